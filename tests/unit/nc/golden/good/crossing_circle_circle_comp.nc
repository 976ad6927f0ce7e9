=== about
proves: nct-17.3.4-AA
=== settings
D1 = 5
=== main
N10 G17 G54 G0 X200 Y10
N20 G42 G1 X180 D1 F100
N30 G3 X130 Y-40 R-50
N40 X90 Y87.446 I50 J30 R70 Q1
N50 G40 G0 Y100
M30
=== truth
200 10 0
185 10 0
117.1175 63.4700 0 center 130 10 0
92.8571 91.5493 0 center 50 30 0
90 100 0
=== expect
file 0 main.nc
1 N10: rapid from 0 0 0 to 200 10 0 t0.8
2 N20: feed to 185 10 0 F100 t9
3 N30: feed arc to 117.1175 63.47 0 center 130 10 0 normal 0 0 1 sweep 103.5461 F100 t59.6383
4 N40: feed arc to 92.8571 91.5493 0 center 50 30 0 normal 0 0 1 sweep 28.6459 F100 t22.4985
5 N50: rapid to 90 100 0 t0.0338
6: event end code="M30"
end of program: 6 blocks, 5 motions, 0 errors, 0 warnings
