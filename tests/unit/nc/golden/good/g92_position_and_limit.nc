=== about
G92 with axis words gives the position new coordinates, with S it limits the spindle in G96: 100 m/min at a radius of
60 mm are 265.26 1/min, at 10 mm they would be 1591.
proves: nct-3-G92 nct-10.2.6-G92 nct-11.5.2-G92S
=== settings
start = 150 100 0
=== main
G90 G0 X150 Y100
G92 X90 Y60
G52 X5
G92 X100
G0 X0 Y0
G92 X60
G92 S300
G96 S100 M3
G1 X61 F100
X10
X9
M30
=== truth
50 40 0
51 40 0 S *
0 40 0 S *
-1 40 0 S 300
=== expect
file 0 main.nc
5: rapid from 150 100 0 to 50 40 0 t0.4
8: event spindle rpm=265.25823848649225 direction="cw"
9: feed to 51 40 0 F100 t0.6
10: feed to 0 40 0 F100 t30.6
11: feed to -1 40 0 F100 t0.6
12: event end code="M30"
end of program: 12 blocks, 4 motions, 0 errors, 0 warnings
