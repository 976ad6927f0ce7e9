=== about
The selections of 9.2: which of several tools of one type is taken.
proves: nct-12.3.1-table nct-12.3.1-select nct-12.4.2-G10L75P2 nct-12.4.3-G10L75P3 nct-12.1-T nct-12.2-M6
=== main
G10 L75 P1
N1 T10002001 Q1 B3 C150 L150
N2 T10002001 Q1 B2 C131 L200
N3 T10002001 Q1 B1 C0 L170
N4 T150 Q10000 B0
N5 T3210 Q1 B4 L10
N6 T3210 Q1 B2 C1 L10
N7 T77 Q1 B2 C8 L10
N8 T77 Q1 B2 C8 L10
N9 T88 Q1 B1 L2
N10 T88 Q1 B1 L5
G11
G10 L75 P2
(only what is given changes)
N4 Q10001
G11
T10002001 M6
G1 F100 X#8401 Y#8403
T3210 M6
X#8401
T150 M6
X#8401
T77 M6
X#8401
G10 L75 P3
N7
G11
T77 M6
X#8401
(two uses of row 9, then it is at its end and row 10 follows)
T88 M6
X#8401 Z#8406
T150 M6
T88 M6
X#8401 Z#8406
T150 M6
T88 M6
X#8401 Z#8406
M30
=== truth
2 132 * T 10002001
6 * * T 3210
4 * * T 150
7 * * T 77
8 * * T 77
9 * 2 T 88
9 * 3 T 88
10 * 2 T 88
=== expect
file 0 main.nc
17: event tool tool=10002001 row=2
18: feed from 0 0 0 to 2 132 0 F100 t79.2091
19: event tool tool=3210 row=6
20: feed to 6 132 0 F100 t2.4
21: event tool tool=150 row=4
22: feed to 4 132 0 F100 t1.2
23: event tool tool=77 row=7
24: feed to 7 132 0 F100 t1.8
28: event tool tool=77 row=8
29: feed to 8 132 0 F100 t0.6
31: event tool tool=88 row=9
32: feed to 9 132 2 F100 t1.3416
33: event tool tool=150 row=4
34: event tool tool=88 row=9
35: feed to 9 132 3 F100 t0.6
36: event tool tool=150 row=4
37: event tool tool=88 row=10
38: feed to 10 132 2 F100 t0.8485
39: event end code="M30"
end of program: 37 blocks, 8 motions, 0 errors, 0 warnings
