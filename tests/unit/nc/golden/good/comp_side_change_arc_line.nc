=== about
G42 to G41 from an arc to a line that does not meet it: the arc keeps its programmed radius, its centre moves.
proves: nct-15.5.4-AX
=== settings
D1 = 10
=== main
G0 X-30 Y-100
G42 G1 Y-60 D1 F1000
Y-30
G2 X0 Y0 I30
G41 G1 X50
X90
G40 X120
M30
=== truth
rapid -30 -100 0
-20 -60 0
-20 -30 0
0 10 0 center 7.8885 -18.9443 0 sweep -96.37937
50 10 0
90 10 0
120 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -30 -100 0 t0.4
2: feed to -20 -60 0 F1000 t2.4739
3: feed to -20 -30 0 F1000 t1.8
4: feed arc to 0 10 0 center 7.8885 -18.9443 0 normal 0 0 1 sweep -96.3794 F1000 t3.0278
5: feed to 50 10 0 F1000 t3
6: feed to 90 10 0 F1000 t2.4
7: feed to 120 0 0 F1000 t1.8974
8: event end code="M30"
end of program: 8 blocks, 7 motions, 0 errors, 0 warnings
