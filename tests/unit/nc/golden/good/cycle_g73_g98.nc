=== about
proves: nct-18.1.1-G73 nct-18-G98 nct-3-G98 nct-3-G73
=== main
G90 G17 G0 X0 Y0 Z20 M3
G98 G73 X0 Y0 Z-30 R2 Q6 E1 F100
G80
M30
=== truth
0 0 20
rapid 0 0 2
feed 0 0 -4
rapid 0 0 -3
feed 0 0 -10
0 0 -9
0 0 -16
0 0 -15
0 0 -22
0 0 -21
0 0 -28
0 0 -27
0 0 -30
rapid 0 0 20
=== expect
file 0 main.nc
1: event spindle rpm=0 direction="cw"
1: rapid from 0 0 0 to 0 0 20 t0.08
2: rapid to 0 0 2 t0.072
2: feed to 0 0 -4 F100 t3.6
2: rapid to 0 0 -3 t0.004
2: feed to 0 0 -10 F100 t4.2
2: rapid to 0 0 -9 t0.004
2: feed to 0 0 -16 F100 t4.2
2: rapid to 0 0 -15 t0.004
2: feed to 0 0 -22 F100 t4.2
2: rapid to 0 0 -21 t0.004
2: feed to 0 0 -28 F100 t4.2
2: rapid to 0 0 -27 t0.004
2: feed to 0 0 -30 F100 t1.8
2: rapid to 0 0 20 t0.2
4: event end code="M30"
end of program: 4 blocks, 14 motions, 0 errors, 0 warnings
