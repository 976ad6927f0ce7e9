=== about
proves: nct-18-ops nct-18-Q nct-18-E nct-18-R nct-18-bottom nct-18.1.7-G83 nct-18-G99 nct-3-G99 nct-3-G83
=== main
G90 G17 G0 X0 Y0 Z20 M3
G99 G83 X0 Y0 Z-30 R2 Q6 E1 F100
G80
M30
=== truth
0 0 20
rapid 0 0 2
feed 0 0 -4
rapid 0 0 2
rapid 0 0 -3
feed 0 0 -10
0 0 2
0 0 -9
0 0 -16
0 0 2
0 0 -15
0 0 -22
0 0 2
0 0 -21
0 0 -28
0 0 2
0 0 -27
feed 0 0 -30
rapid 0 0 2
=== expect
file 0 main.nc
1: event spindle rpm=0 direction="cw"
1: rapid from 0 0 0 to 0 0 20 t0.08
2: rapid to 0 0 2 t0.072
2: feed to 0 0 -4 F100 t3.6
2: rapid to 0 0 2 t0.024
2: rapid to 0 0 -3 t0.02
2: feed to 0 0 -10 F100 t4.2
2: rapid to 0 0 2 t0.048
2: rapid to 0 0 -9 t0.044
2: feed to 0 0 -16 F100 t4.2
2: rapid to 0 0 2 t0.072
2: rapid to 0 0 -15 t0.068
2: feed to 0 0 -22 F100 t4.2
2: rapid to 0 0 2 t0.096
2: rapid to 0 0 -21 t0.092
2: feed to 0 0 -28 F100 t4.2
2: rapid to 0 0 2 t0.12
2: rapid to 0 0 -27 t0.116
2: feed to 0 0 -30 F100 t1.8
2: rapid to 0 0 2 t0.128
4: event end code="M30"
end of program: 4 blocks, 19 motions, 0 errors, 0 warnings
