=== about
A new radius in an arc: the arc runs from radius 20 to 25 about its centre.
proves: nct-15.5.2-newD
=== settings
D1 = 10
D2 = 5
=== main
G0 X-100
G41 G1 X-50 D1 F1000
X0
G3 X30 Y30 J30 D2
G1 Y60
Y90
G40 Y120
M30
=== truth
-100 0 0
-50 10 0
0 10 0
25 30 0 center 0 30 0 sweep 90 at 0.5 15.9099 14.0901 0
25 60 0
25 90 0
30 120 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: feed to -50 10 0 F1000 t3.0594
3: feed to 0 10 0 F1000 t3
4: feed arc to 25 30 0 center 0 30 0 normal 0 0 1 sweep 90 F833.3333 t2.5701
5: feed to 25 60 0 F1000 t1.8
6: feed to 25 90 0 F1000 t1.8
7: feed to 30 120 0 F1000 t1.8248
8: event end code="M30"
end of program: 8 blocks, 7 motions, 0 errors, 0 warnings
