=== about
proves: nct-17.1-R
=== settings
D1 = 4
=== main
G17 G90 G0 X0 Y-20
G51.1 X0
G41 G1 Y0 D1 F100
X-50 ,R10
Y-50
G40 X-70
M30
=== truth
0 -20 0
0 -4 0
40 -4 0
46 -10 0 center 40 -10 0 sweep -90
46 -54 0
70 -50 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 -20 0 t0.08
3: feed to 0 -4 0 F100 t9.6
4: feed to 40 -4 0 F100 t24
4: feed arc to 46 -10 0 center 40 -10 0 normal 0 0 1 sweep -90 F60 t9.4248
5: feed to 46 -54 0 F100 t26.4
6: feed to 70 -50 0 F100 t14.5986
7: event end code="M30"
end of program: 7 blocks, 6 motions, 0 errors, 0 warnings
