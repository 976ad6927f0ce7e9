=== about
G42 to G41 on a straight line and at a turn back: no meeting point.
proves: nct-15.5.4-LL nct-15.5.4-change
=== settings
D1 = 10
=== main
G0 X-100
G42 G1 X-50 D1 F1000
X0
G41 X50
X90
G40 X120
G0 X-100 Y0
G42 G1 X-50
X0
G41 X-50
X-90
G40 X-120
M30
=== truth
rapid -100 0 0
-50 -10 0
0 10 0
50 10 0
90 10 0
120 0 0
rapid -100 0 0
-50 -10 0
0 -10 0
-50 -10 0
-90 -10 0
-120 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: feed to -50 -10 0 F1000 t3.0594
3: feed to 0 10 0 F1000 t3.2311
4: feed to 50 10 0 F1000 t3
5: feed to 90 10 0 F1000 t2.4
6: feed to 120 0 0 F1000 t1.8974
7: rapid to -100 0 0 t0.88
8: feed to -50 -10 0 F1000 t3.0594
9: feed to 0 -10 0 F1000 t3
10: feed to -50 -10 0 F1000 t3
11: feed to -90 -10 0 F1000 t2.4
12: feed to -120 0 0 F1000 t1.8974
13: event end code="M30"
end of program: 13 blocks, 12 motions, 0 errors, 0 warnings
