=== about
N1337.HEF = 0: F150 is the speed along the circle, 151.211 along the path.
proves: nct-4.3.2-helix
=== main
G17 G90 G0 X100 Y0 Z0
G03 X0 Y100 Z20 R100 F150
G0 X-50 Y0
Z0
G2 I50 Z-20 L4 F100
M30
=== truth
100 0 0
0 100 20 center 0 0 0 sweep 90 t 62.8319
-50 0 20
-50 0 0
-50 0 -20 center 0 0 0 sweep -1440 t 753.9822
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 100 0 0 t0.4
2: feed arc to 0 100 20 center 0 0 0 normal 0 0 1 sweep 90 F151.211 t62.8319
3: rapid to -50 0 20 t0.4
4: rapid to -50 0 0 t0.08
5: feed arc to -50 0 -20 center 0 0 0 normal 0 0 1 sweep -1440 F100.0127 t753.9822
6: event end code="M30"
end of program: 6 blocks, 5 motions, 0 errors, 0 warnings
