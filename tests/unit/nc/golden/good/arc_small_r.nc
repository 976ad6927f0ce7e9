=== about
proves: nct-4.3-Rsmall
=== settings
N1339 = 30
=== main
G17 G0 G90 X10 Y0
G0 X0 Y0 F500
G2 X40 Y30 R10
M30
=== truth
10 0 0
0 0 0
40 30 0 center 8 6 0 sweep -180 at 0.5 -7 26 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 10 0 0 t0.04
2: rapid to 0 0 0 t0.04
3: feed arc to 40 30 0 center 8 6 0 normal 0 0 1 sweep -180 F1348.677 t3.7699
4: event end code="M30"
end of program: 4 blocks, 3 motions, 0 errors, 0 warnings
