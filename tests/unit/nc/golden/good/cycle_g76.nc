=== about
proves: nct-18-IJK nct-18.1.3-G76 nct-3-G76
=== main
G0 X0 Y0 Z50 S100 M3
G99 G76 X10 Y0 I-1 Z-25 R2 P1 F40
M30
=== truth
0 0 50
10 0 50
10 0 2
feed 10 0 -25
rapid 9 0 -25
rapid 9 0 2
rapid 10 0 2
=== says
feed to 10 0 -25
dwell seconds=1
direction="oriented"
rapid to 9 0 -25
rapid to 10 0 2
direction="cw"
=== expect
file 0 main.nc
1: event spindle rpm=100 direction="cw"
1: rapid from 0 0 0 to 0 0 50 t0.2
2: rapid to 10 0 50 t0.04
2: rapid to 10 0 2 t0.192
2: feed to 10 0 -25 F40 t40.5
2: event dwell seconds=1
2: event spindle rpm=0 direction="oriented"
2: rapid to 9 0 -25 t0.004
2: rapid to 9 0 2 t0.108
2: rapid to 10 0 2 t0.004
2: event spindle rpm=100 direction="cw"
3: event end code="M30"
end of program: 3 blocks, 7 motions, 0 errors, 0 warnings
