=== about
proves: nct-18.1.13-G87B nct-3-G87
=== main
G0 X0 Y0 Z50 S100 M3
G98 G87 X10 Y0 I-2 J0 Z-20 R-30 F60
M30
=== truth
0 0 50
10 0 50
8 0 50
8 0 -30
10 0 -30
feed 10 0 -20
8 0 -20
8 0 50
10 0 50
=== says
rapid to 10 0 50
direction="oriented"
rapid to 8 0 50
rapid to 8 0 -30
rapid to 10 0 -30
direction="cw"
feed to 10 0 -20
direction="oriented"
rapid to 8 0 -20
rapid to 8 0 50
rapid to 10 0 50
direction="cw"
=== expect
file 0 main.nc
1: event spindle rpm=100 direction="cw"
1: rapid from 0 0 0 to 0 0 50 t0.2
2: rapid to 10 0 50 t0.04
2: event spindle rpm=0 direction="oriented"
2: rapid to 8 0 50 t0.008
2: rapid to 8 0 -30 t0.32
2: rapid to 10 0 -30 t0.008
2: event spindle rpm=100 direction="cw"
2: feed to 10 0 -20 F60 t10
2: event spindle rpm=0 direction="oriented"
2: rapid to 8 0 -20 t0.008
2: rapid to 8 0 50 t0.28
2: rapid to 10 0 50 t0.008
2: event spindle rpm=100 direction="cw"
3: event end code="M30"
end of program: 3 blocks, 9 motions, 0 errors, 0 warnings
