=== about
The manual's table of planes: the axes named beside G17, G18, G19, their parallel ones, the main axis where one is missing; without a code
the plane stays. A quarter from the first axis to the second shows it.
proves: nct-10.4-G17 nct-10.4-G18 nct-10.4-G19 nct-2.1-N0103
=== settings
axis = U 4 linear parallel X
axis = V 5 linear parallel Y
axis = W 6 linear parallel Z
=== main
G1 G91 F1000
G17 G1 X1 Y1
G3 X-10 Y10 R10
G17 G1 X1 V1
G3 X-10 V10 R10
G17 G1 U1 V1
G3 U-10 V10 R10
G18 G1 X1 W1
G3 W-10 X10 R10
G19 G1 Y1 Z1
G3 Y-10 Z10 R10
G19 G1 V1 Z1
G3 V-10 Z10 R10
G17
G3 X-10 Y10 R10
G17 G1 X1
G3 X-10 Y10 R10
G17 G1 U1
G3 U-10 Y10 R10
G17 G1 V1
G3 X-10 V10 R10
G18
G3 Z-10 X10 R10
G18 G1 W1
G3 W-10 X10 R10
G17 G1 X1 Y1
U1 Y1
G3 X-10 Y10 R10
G18
G90 G17 G00 Z100
G91
G3 X-10 Y10 R10
M30
=== truth
feed 1 1 0
feed -9 11 0 center -9 1 0 sweep 90
feed -8 12 0
feed -18 22 0 center -18 12 0 sweep 90
feed -17 23 0
feed -27 33 0 center -27 23 0 sweep 90
feed -26 33 1
feed -16 33 -9 center -26 33 -9 sweep 90
feed -16 34 -8
feed -16 24 2 center -16 24 -8 sweep 90
feed -16 25 3
feed -16 15 13 center -16 15 3 sweep 90
feed -26 25 13 center -26 15 13 sweep 90
feed -25 25 13
feed -35 35 13 center -35 25 13 sweep 90
feed -34 35 13
feed -44 45 13 center -44 35 13 sweep 90
feed -44 46 13
feed -54 56 13 center -54 46 13 sweep 90
feed -44 56 3 center -54 56 3 sweep 90
feed -44 56 4
feed -34 56 -6 center -44 56 -6 sweep 90
feed -33 57 -6
feed -32 58 -6
feed -42 68 -6 center -42 58 -6 sweep 90
rapid -42 68 82
feed -52 78 82 center -52 68 82 sweep 90
=== expect
file 0 main.nc
2: feed from 0 0 0 to 1 1 0 F1000 t0.0849
3: feed arc to -9 11 0 center -9 1 0 normal 0 0 1 sweep 90 F1000 t0.9425
4: feed to -8 12 0 F1000 t0.0849
5: feed arc to -18 22 0 center -18 12 0 normal 0 0 1 sweep 90 F1000 t0.9425
6: feed to -17 23 0 F1000 t0.0849
7: feed arc to -27 33 0 center -27 23 0 normal 0 0 1 sweep 90 F1000 t0.9425
8: feed to -26 33 1 F1000 t0.0849
9: feed arc to -16 33 -9 center -26 33 -9 normal 0 1 0 sweep 90 F1000 t0.9425
10: feed to -16 34 -8 F1000 t0.0849
11: feed arc to -16 24 2 center -16 24 -8 normal 1 0 0 sweep 90 F1000 t0.9425
12: feed to -16 25 3 F1000 t0.0849
13: feed arc to -16 15 13 center -16 15 3 normal 1 0 0 sweep 90 F1000 t0.9425
15: feed arc to -26 25 13 center -26 15 13 normal 0 0 1 sweep 90 F1000 t0.9425
16: feed to -25 25 13 F1000 t0.06
17: feed arc to -35 35 13 center -35 25 13 normal 0 0 1 sweep 90 F1000 t0.9425
18: feed to -34 35 13 F1000 t0.06
19: feed arc to -44 45 13 center -44 35 13 normal 0 0 1 sweep 90 F1000 t0.9425
20: feed to -44 46 13 F1000 t0.06
21: feed arc to -54 56 13 center -54 46 13 normal 0 0 1 sweep 90 F1000 t0.9425
23: feed arc to -44 56 3 center -54 56 3 normal 0 1 0 sweep 90 F1000 t0.9425
24: feed to -44 56 4 F1000 t0.06
25: feed arc to -34 56 -6 center -44 56 -6 normal 0 1 0 sweep 90 F1000 t0.9425
26: feed to -33 57 -6 F1000 t0.0849
27: feed to -32 58 -6 F1000 t0.0849
28: feed arc to -42 68 -6 center -42 58 -6 normal 0 0 1 sweep 90 F1000 t0.9425
30: rapid to -42 68 82 t0.352
32: feed arc to -52 78 82 center -52 68 82 normal 0 0 1 sweep 90 F1000 t0.9425
33: event end code="M30"
end of program: 33 blocks, 27 motions, 0 errors, 0 warnings
