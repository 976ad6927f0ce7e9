=== about
Compensation outside: arcs about the corners; inside: intersections.
proves: wl4-6.2-G40 wl4-6.2-G41 wl4-6.2-G42 wl4-4.2-D wl4-9.2-102 wl4-9.2-141
=== settings
control = wl4-mill
D1 = 2
D2 = 3
=== main
%COMP
G54 G0 X0 Y-10
G41 D1 G1 X10 F100
Y10
X30
Y-20
G40 X40
G0 X0 Y0
G42 D2 X10
Y10
X30
G40 Y0
Z#141 Y#102
M30
%
=== truth
rapid 0 -10 0
feed 8 -10 0
feed 8 10 0
feed 10 12 0 center 10 10 0 sweep -90
feed 30 12 0
feed 32 10 0 center 30 10 0 sweep -90
feed 32 -20 0
feed 40 -20 0
rapid 0 0 0
rapid 13 0 0
rapid 13 7 0
rapid 30 7 0
rapid 30 0 0
rapid 30 40 2
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 0 -10 0 t0.04
3: feed to 8 -10 0 F100 t4.8
4: feed to 8 10 0 F100 t12
4: feed arc to 10 12 0 center 10 10 0 normal 0 0 1 sweep -90 F100 t1.885
5: feed to 30 12 0 F100 t12
5: feed arc to 32 10 0 center 30 10 0 normal 0 0 1 sweep -90 F100 t1.885
6: feed to 32 -20 0 F100 t18
7: feed to 40 -20 0 F100 t4.8
8: rapid to 0 0 0 t0.16
9: rapid to 13 0 0 t0.052
10: rapid to 13 7 0 t0.028
11: rapid to 30 7 0 t0.068
12: rapid to 30 0 0 t0.028
13: rapid to 30 40 2 t0.16
14: event end code="M30"
end of program: 13 blocks, 14 motions, 0 errors, 0 warnings
