=== about
Bits of tool data in writing: #4 to #0. UENCV is 1, SDLCV 29, SENTV 19, SENCV 17 in #8408.
proves: nct-12.3.1-table nct-23.1.20-#8408
=== main
G10 L75 P1
N1 T11 Q1 B1 L9
N2 T12 Q11101 B1 L9
N3 T13 Q10011 B1 L9
N4 T14 Q10001 B0
G11
G0
T11 M6
X#8408
T12 M6
X#8408
T13 M6
X#8408
T14 M6
X#8408
M30
=== truth
1 0 0 T 11
29 0 0 T 12
19 0 0 T 13
17 0 0 T 14
=== expect
file 0 main.nc
8: event tool tool=11 row=1
9: rapid from 0 0 0 to 1 0 0 t0.004
10: event tool tool=12 row=2
11: rapid to 29 0 0 t0.112
12: event tool tool=13 row=3
13: rapid to 19 0 0 t0.04
14: event tool tool=14 row=4
15: rapid to 17 0 0 t0.008
16: event end code="M30"
end of program: 16 blocks, 4 motions, 0 errors, 0 warnings
