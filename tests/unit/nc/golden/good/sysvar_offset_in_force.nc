=== about
Geometry and wear by variable, the sum in force by #5083 (350 - 0.13); a changed cell acts when H or D comes again.
proves: nct-23.1.18-#10001 nct-23.1.18-#11001 nct-23.1.18-#12001 nct-23.1.16-tofs nct-15.1-H nct-15.1-D
=== settings
reference1 = 0 0 0
=== main
#10001=350
#11001=-0.13
#12002=4
G43 G0 Z0 H1
#100=#5083
#10001=100
Z1
#_OFSHW[1]=0
Z1 H1
G53 Z#100
G49 G17 Z0
G1 G41 D2 X0 Y0 F100
#12002=8
X10 Y0
G40 Y0
M30
=== truth
0 0 349.87
0 0 350.87
0 0 101
0 0 349.87
0 0 0
0 4 0
10 4 0
10 0 0
=== expect
file 0 main.nc
4: rapid from 0 0 0 to 0 0 349.87 t1.3995
7: rapid to 0 0 350.87 t0.004
9: rapid to 0 0 101 t0.9995
10: rapid to 0 0 349.87 t0.9955
11: rapid to 0 0 0 t1.3995
12: feed to 0 4 0 F100 t2.4
14: feed to 10 4 0 F100 t6
14: feed to 10 0 0 F100 t2.4
16: event end code="M30"
end of program: 16 blocks, 8 motions, 0 errors, 0 warnings
