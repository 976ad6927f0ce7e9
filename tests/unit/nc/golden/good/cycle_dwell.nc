=== about
10 mm at 10 mm/s, dwell, 10 mm at 250 mm/s. P1.5 is 1.5 s in G94; P5 is 5 turns at 600 rpm, 0.5 s, in G95. X is the clock in seconds.
proves: nct-18-P
=== main
G0 Z2 S600 M3
#3001=0
G82 Z-8 R2 P1.5 F600
G80 X[#3001/1000]
#3001=0
G95 G82 Z-8 R2 P5 F1
G80 X[#3001/1000]
M30
=== truth
0 0 2
feed 0 0 -8 t 1
0 0 2 t 0.04
2.54 0 2
feed 2.54 0 -8 t 1
2.54 0 2 t 0.04
1.54 0 2
=== expect
file 0 main.nc
1: event spindle rpm=600 direction="cw"
1: rapid from 0 0 0 to 0 0 2 t0.008
3: feed to 0 0 -8 F600 t1
3: event dwell seconds=1.5
3: rapid to 0 0 2 t0.04
4: rapid to 2.54 0 2 t0.0102
6: feed to 2.54 0 -8 F600 t1
6: event dwell seconds=0.5
6: rapid to 2.54 0 2 t0.04
7: rapid to 1.54 0 2 t0.004
8: event end code="M30"
end of program: 8 blocks, 7 motions, 0 errors, 0 warnings
