=== about
The frame of the manual's turning program on a mill: G43.7 with X in diameter. Turning lengths of that axis are diameters:
100 is 50 of radius; #5081 tells 100.
proves: nct-15.4-G43.7 nct-15.4-G49 nct-5.3-DIA
=== settings
start = 0 0 100
=== main
G10 L201 P5 X100 Y0 Z40 R0.4 Q3
G49 H0 D0
G10.9 X1
T5 M6
G54 G0 X200 Y0 Z100
G43.7 H5
#100=#5081
G18 G95 G0 X101 Z1 S3000
G96 S400 P1 M3
G92 S200
G94 G1 X90 F100
Y#100
G49 G0 X200 Z100 H0 D0
G10.9 X0
G43
G0 X1
M30
=== truth
100 0 100
100.5 0 41
feed 95 0 41
feed 95 100 41
100 100 100
1 100 100
=== says
tool tool=5
=== expect
file 0 main.nc
4: event tool tool=5
5: rapid from 0 0 100 to 100 0 100 t0.4
8: rapid to 100.5 0 41 t0.236
9: event spindle rpm=1260.633212609072 direction="cw"
10: event spindle rpm=200 direction="cw"
11: feed to 95 0 41 F100 t3.3
12: feed to 95 100 41 F100 t60
13: rapid to 100 100 100 t0.236
16: rapid to 1 100 100 t0.396
17: event end code="M30"
end of program: 17 blocks, 6 motions, 0 errors, 0 warnings
