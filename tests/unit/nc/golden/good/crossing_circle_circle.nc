=== about
proves: nct-17.3.4-AA
=== settings
D1 = 0
=== main
N10 G17 G54 G0 X200 Y10
N20 G42 G1 X180 D1 F100
N30 G3 X130 Y-40 R-50
N40 X90 Y87.446 I50 J30 R70 Q-1
N50 G40 G0 Y100
N60 X200 Y10
N20 G42 G1 X180 D1
N30 G3 X130 Y-40 R-50
N40 X90 Y87.446 I50 J30 R70 Q1
N50 G40 G0 Y100
M30
=== truth
200 10 0
180 10 0
93.8614 -24.5543 0 center 130 10 0 sweep 223.7162
90 87.446 0 center 50 30 0 sweep 106.3512
90 100 0
200 10 0
180 10 0
114.3739 57.4955 0 center 130 10 0 sweep 108.2113
90 87.446 0 center 50 30 0 sweep 32.0219
90 100 0
=== expect
file 0 main.nc
1 N10: rapid from 0 0 0 to 200 10 0 t0.8
2 N20: feed to 180 10 0 F100 t12
3 N30: feed arc to 93.8614 -24.5543 0 center 130 10 0 normal 0 0 1 sweep 223.7162 F100 t117.1375
4 N40: feed arc to 90 87.446 0 center 50 30 0 normal 0 0 1 sweep 106.3512 F100 t77.9596
5 N50: rapid to 90 100 0 t0.0502
6 N60: rapid to 200 10 0 t0.44
7 N20: feed to 180 10 0 F100 t12
8 N30: feed arc to 114.3739 57.4955 0 center 130 10 0 normal 0 0 1 sweep 108.2113 F100 t56.6593
9 N40: feed arc to 90 87.446 0 center 50 30 0 normal 0 0 1 sweep 32.0219 F100 t23.4733
10 N50: rapid to 90 100 0 t0.0502
11: event end code="M30"
end of program: 11 blocks, 10 motions, 0 errors, 0 warnings
