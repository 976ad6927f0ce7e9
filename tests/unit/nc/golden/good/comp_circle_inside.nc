=== about
proves: nct-15.5-G42
=== settings
D1 = 10
H1 = 0
=== main
N50 G0 X0 Y0
N60 G43 Z1 H1
N70 G1 Z-2 F1000
N80 G42 G0 X10 Y50 D1
N90 G2 X60 Y0 R50
N100 G2 I-60
N110 G2 X10 Y-50 R50
N120 G40 G0 X0 Y0
M30
=== truth
0 0 1
0 0 -2
10 40 -2
50 0 -2 center 10 0 -2
50 0 -2 center 0 0 -2 sweep -360
10 -40 -2 center 10 0 -2
0 0 -2
=== expect
file 0 main.nc
2 N60: rapid from 0 0 0 to 0 0 1 t0.004
3 N70: feed to 0 0 -2 F1000 t0.18
4 N80: rapid to 10 40 -2 t0.16
5 N90: feed arc to 50 0 -2 center 10 0 -2 normal 0 0 1 sweep -90 F800 t4.7124
6 N100: feed arc to 50 0 -2 center 0 0 -2 normal 0 0 1 sweep -360 F833.3333 t22.6195
7 N110: feed arc to 10 -40 -2 center 10 0 -2 normal 0 0 1 sweep -90 F800 t4.7124
8 N120: rapid to 0 0 -2 t0.16
9: event end code="M30"
end of program: 9 blocks, 7 motions, 0 errors, 0 warnings
