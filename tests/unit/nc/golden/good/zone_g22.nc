=== about
Manual 22.2: within the area of G22 P1, around the box of P0, X=I Y=J Z=K with P0 allows everything; G23 takes the area away, and the
limits of a work offset do not count: they are machine coordinates. An arc around the box passes although its chord does not.
proves: nct-22.2-G22 nct-22.2-G23 nct-3-G22 nct-3-G23
=== settings
G54 = 1000 0 0
=== main
G22 X1100 Y100 Z50 I900 J-100 K-50 P1
G0 X100
Y100 Z-50
X-100 Y-100 Z50
G22 X1010 Y10 Z10 I990 J-10 K-10
G0 X-50 Y0 Z20
Z0
G17 G2 X50 I50 F1000
G22 X1 Y2 Z3 I1 J2 K3 P0
G0 X0
G23
X500
M30
=== truth
100 0 0
100 100 -50
-100 -100 50
-50 0 20
-50 0 0
50 0 0 sweep -180
0 0 0
500 0 0
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 100 0 0 t0.4
3: rapid to 100 100 -50 t0.4
4: rapid to -100 -100 50 t0.8
6: rapid to -50 0 20 t0.4
7: rapid to -50 0 0 t0.08
8: feed arc to 50 0 0 center 0 0 0 normal 0 0 1 sweep -180 F1000 t9.4248
10: rapid to 0 0 0 t0.2
12: rapid to 500 0 0 t2
13: event end code="M30"
end of program: 13 blocks, 8 motions, 0 errors, 0 warnings
