=== about
A spiral from radius 50 to 20 about the origin: the tool's radius is taken off along the spiral; an inner corner before it, an outer one
behind it.
proves: nct-15.5.2-spiral
=== settings
D1 = 5
=== main
G41 G1 X10 D1 F1000
X50
G3 X-20 I-50 L1
G1 X-30
G40 X-60
M30
=== truth
10 5 0
44.7214 5 0
-15 0 0
-15 -5 0
-30 -5 0
-60 0 0
=== expect
file 0 main.nc
1: feed from 0 0 0 to 10 5 0 F1000 t0.6708
2: feed to 44.7214 5 0 F1000 t2.0833
3: feed arc to -15 0 0 center 0 0 0 normal 0 0 1 sweep 173.6206 F750 t7.6905
3: feed to -15 -5 0 F1000 t0.3
4: feed to -30 -5 0 F1000 t0.9
5: feed to -60 0 0 F1000 t1.8248
6: event end code="M30"
end of program: 6 blocks, 6 motions, 0 errors, 0 warnings
