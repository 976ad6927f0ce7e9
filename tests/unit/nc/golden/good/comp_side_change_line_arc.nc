=== about
G42 to G41 from a line to an arc that bends away: the line ends square to the arc's start on the new side.
proves: nct-15.5.4-LA
=== settings
D1 = 10
=== main
G0 X-100
G42 G1 X-50 D1 F1000
X0
G41 G3 X30 Y30 J30
G1 Y60
G40 Y80
M30
=== truth
rapid -100 0 0
-50 -10 0
0 10 0
20 30 0 center 0 30 0 sweep 90
20 60 0
30 80 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: feed to -50 -10 0 F1000 t3.0594
3: feed to 0 10 0 F1000 t3.2311
4: feed arc to 20 30 0 center 0 30 0 normal 0 0 1 sweep 90 F666.6667 t2.8274
5: feed to 20 60 0 F1000 t1.8
6: feed to 30 80 0 F1000 t1.3416
7: event end code="M30"
end of program: 7 blocks, 6 motions, 0 errors, 0 warnings
