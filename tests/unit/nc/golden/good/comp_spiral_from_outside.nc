=== about
Onto the spiral from outside: an outer corner of two points, (45,-5) and (45,0); radius 45 to 15.
proves: nct-15.5.2-spiral
=== settings
D1 = 5
=== main
G0 X110
G41 G1 X80 D1 F1000
X50
G3 X-20 I-50 L1
G1 X-30
G40 X-60
M30
=== truth
110 0 0
80 -5 0
45 -5 0
45 0 0
-15 0 0 center 0 0 0 sweep 180 at 0.5 0 30 0
-15 -5 0
-30 -5 0
-60 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 110 0 0 t0.44
2: feed to 80 -5 0 F1000 t1.8248
3: feed to 45 -5 0 F1000 t2.1
3: feed to 45 0 0 F1000 t0.3
4: feed arc to -15 0 0 center 0 0 0 normal 0 0 1 sweep 180 F750 t7.9439
4: feed to -15 -5 0 F1000 t0.3
5: feed to -30 -5 0 F1000 t0.9
6: feed to -60 0 0 F1000 t1.8248
7: event end code="M30"
end of program: 7 blocks, 8 motions, 0 errors, 0 warnings
