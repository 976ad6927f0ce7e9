=== about
The square of the G17 example with u = Z, v = X.
proves: nct-15.5-G42 nct-3-G18
=== settings
D1 = 5
H1 = 0
=== main
N10 G18 G49
N20 G0 Z-40 X-40
N50 G42 G0 Z0 X0 D1 F500
N60 G1 Z60
N70 X60
N80 Z0
N90 X0
N100 G40 G0 Z-40 X-40
N110 M30
=== truth
-40 0 -40
-5 0 0
-5 0 65
65 0 65
65 0 -5
0 0 -5
-40 0 -40
=== expect
file 0 main.nc
2 N20: rapid from 0 0 0 to -40 0 -40 t0.16
3 N50: rapid to -5 0 0 t0.16
4 N60: feed to -5 0 65 F500 t7.8
5 N70: feed to 65 0 65 F500 t8.4
6 N80: feed to 65 0 -5 F500 t8.4
7 N90: feed to 0 0 -5 F500 t7.8
8 N100: rapid to -40 0 -40 t0.16
9 N110: event end code="M30"
end of program: 9 blocks, 7 motions, 0 errors, 0 warnings
