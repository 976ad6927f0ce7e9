=== about
proves: nct-4.3-R nct-4.3-G2 nct-4.3-G3
=== main
G0 X0 Y0 F500
G2 X50 Y40 R40
G0 X0 Y0
G2 X50 Y40 R-40
G0 X0 Y0
G3 X50 Y40 R40
G0 X0 Y0
G3 X50 Y40 R-40
M30
=== truth
50 40 0 center 39.9797 1.2754 0 sweep -106.3348
0 0 0
50 40 0 center 10.0203 38.7246 0 sweep -253.6652
0 0 0
50 40 0 center 10.0203 38.7246 0 sweep 106.3348
0 0 0
50 40 0 center 39.9797 1.2754 0 sweep 253.6652
=== expect
file 0 main.nc
2: feed arc from 0 0 0 to 50 40 0 center 39.9797 1.2754 0 normal 0 0 1 sweep -106.3348 F500 t8.9083
3: rapid to 0 0 0 t0.2
4: feed arc to 50 40 0 center 10.0203 38.7246 0 normal 0 0 1 sweep -253.6652 F500 t21.251
5: rapid to 0 0 0 t0.2
6: feed arc to 50 40 0 center 10.0203 38.7246 0 normal 0 0 1 sweep 106.3348 F500 t8.9083
7: rapid to 0 0 0 t0.2
8: feed arc to 50 40 0 center 39.9797 1.2754 0 normal 0 0 1 sweep 253.6652 F500 t21.251
9: event end code="M30"
end of program: 9 blocks, 7 motions, 0 errors, 0 warnings
