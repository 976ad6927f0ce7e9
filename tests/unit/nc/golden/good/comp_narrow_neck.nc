=== about
A cavity behind a neck of 8 mm, cutter of radius 5: with three more blocks of look-ahead (N1404) the control does not see
both walls of the neck, and the tool goes in.
proves: nct-15.5.7-N1404
=== settings
D1 = 5
N1404 = 3
=== main
G0 X-100
G41 G1 X-50 D1 F1000
X0
X40
Y-10
X20
Y-40
X68
Y-10
X48
Y0
X90
X120
G40 X150
M30
=== truth
-100 0 0
-50 5 0
0 5 0
45 5 0
45 -15 0
25 -15 0
25 -35 0
63 -35 0
63 -15 0
43 -15 0
43 5 0
90 5 0
120 5 0
150 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: feed to -50 5 0 F1000 t3.015
3: feed to 0 5 0 F1000 t3
4: feed to 45 5 0 F1000 t2.7
5: feed to 45 -15 0 F1000 t1.2
6: feed to 25 -15 0 F1000 t1.2
7: feed to 25 -35 0 F1000 t1.2
8: feed to 63 -35 0 F1000 t2.28
9: feed to 63 -15 0 F1000 t1.2
10: feed to 43 -15 0 F1000 t1.2
11: feed to 43 5 0 F1000 t1.2
12: feed to 90 5 0 F1000 t2.82
13: feed to 120 5 0 F1000 t1.8
14: feed to 150 0 0 F1000 t1.8248
15: event end code="M30"
end of program: 15 blocks, 14 motions, 0 errors, 0 warnings
