=== about
The tip code of D: the path is told of the point that lies from the nose centre as the code says, seen with the first
and second axis of the plane. 0 and 9 are the centre itself; D0 has no tip.
proves: nct-15.1-Q
=== settings
N1416.TOL = 1
start = 0 0 100
=== main
G10 L201 P1 R2 Q3
G10 L201 P2 R2 Q1
G10 L201 P3 R2 Q9
G18 G41 D1 G0 X0 Z0
G1 X20 F100
G40 X30
G0 Z100
X0
G41 D2 Z0
G1 X20
G2 X25 Z5 R5
G40 G1 X30
G0 Z100
X0
G41 D3 Z0
G1 X20
G40 X30
M30
=== truth
-4 0 -4
18 0 -4
30 0 0
30 0 100
0 0 100
0 0 0
*
*
*
*
*
-2 0 -2
20 0 -2
30 0 0
=== expect
file 0 main.nc
4: rapid from 0 0 100 to -4 0 -4 t0.416
5: feed to 18 0 -4 F100 t13.2
6: feed to 30 0 0 F100 t7.5895
7: rapid to 30 0 100 t0.4
8: rapid to 0 0 100 t0.12
9: rapid to 0 0 0 t0.4
10: feed to 22 0 0 F100 t13.2
11: feed arc to 29 0 7 center 22 0 7 normal 0 1 0 sweep -90 F100 t6.5973
12: feed to 30 0 5 F100 t1.3416
13: rapid to 30 0 100 t0.38
14: rapid to 0 0 100 t0.12
15: rapid to -2 0 -2 t0.408
16: feed to 20 0 -2 F100 t13.2
17: feed to 30 0 0 F100 t6.1188
18: event end code="M30"
end of program: 18 blocks, 14 motions, 0 errors, 0 warnings
