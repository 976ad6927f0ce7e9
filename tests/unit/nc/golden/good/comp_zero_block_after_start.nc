=== about
proves: nct-15.5.1-nextzero nct-15.5-G42
=== settings
D1 = 5
H1 = 0
=== main
N20 G0 X-10 Y-40
N40 G1 Z-5 F500
N50 G42 G0 X0 Y0 D1
N60 G1 X0
N70 X60
N80 Y60
N90 X0
N100 Y0
N110 Y0
N120 G40 G0 X-40 Y-10
M30
=== truth
-10 -40 0
-10 -40 -5
4.8507 -1.2127 -5
0 -5 -5
65 -5 -5
65 65 -5
-5 65 -5
-5 0 -5
-40 -10 -5
=== expect
file 0 main.nc
1 N20: rapid from 0 0 0 to -10 -40 0 t0.16
2 N40: feed to -10 -40 -5 F500 t0.6
3 N50: rapid to 4.8507 -1.2127 -5 t0.1551
4 N60: feed to 0 -5 -5 F500 t0.7385
5 N70: feed to 65 -5 -5 F500 t7.8
6 N80: feed to 65 65 -5 F500 t8.4
7 N90: feed to -5 65 -5 F500 t8.4
8 N100: feed to -5 0 -5 F500 t7.8
10 N120: rapid to -40 -10 -5 t0.14
11: event end code="M30"
end of program: 11 blocks, 9 motions, 0 errors, 0 warnings
