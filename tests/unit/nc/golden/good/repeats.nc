=== about
L counts calls (M98, G65), holes of a cycle and turns of an arc.
proves: nct-1.1-L
=== main
M98 P11 L3
G65 P11 L2
G90 G0 X0
G91 G81 X10 Z-3 R-1 F100 L2
G80 G90
G2 I5 L3
M30
=== sub O0011
G91 G0 X1
M99
=== truth
1 0 0
2 0 0
3 0 0
4 0 0
5 0 0
0 0 0
10 0 0
10 0 -1
10 0 -4
10 0 0
20 0 0
20 0 -1
20 0 -4
20 0 0
20 0 0 center 25 0 0 sweep -1080
=== expect
file 0 main.nc
file 1 O0011
1/1 depth 1: rapid from 0 0 0 to 1 0 0 t0.004
1/1 depth 1: rapid to 2 0 0 t0.004
1/1 depth 1: rapid to 3 0 0 t0.004
1/1 depth 1: rapid to 4 0 0 t0.004
1/1 depth 1: rapid to 5 0 0 t0.004
3: rapid to 0 0 0 t0.02
4: rapid to 10 0 0 t0.04
4: rapid to 10 0 -1 t0.004
4: feed to 10 0 -4 F100 t1.8
4: rapid to 10 0 0 t0.016
4: rapid to 20 0 0 t0.04
4: rapid to 20 0 -1 t0.004
4: feed to 20 0 -4 F100 t1.8
4: rapid to 20 0 0 t0.016
6: feed arc to 20 0 0 center 25 0 0 normal 0 0 1 sweep -1080 F100 t56.5487
7: event end code="M30"
end of program: 17 blocks, 15 motions, 0 errors, 0 warnings
