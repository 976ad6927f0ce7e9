=== about
proves: nct-17.3.4-AA
=== main
N10 G17 G54 G0 X200 Y10
N20 G42 G1 X180 D0 F100
N30 G3 X130 Y-40 R-50 ,R20
N40 X90 Y87.446 I50 J30 R70 Q1
N50 G40 G0 Y100
M30
=== truth
200 10 0
180 10 0
126.3961 59.8699 0 center 130 10 0
108.2979 68.7473 0 center 124.9545 79.8179 0
90 87.446 0 center 50 30 0
90 100 0
=== expect
file 0 main.nc
1 N10: rapid from 0 0 0 to 200 10 0 t0.8
2 N20: feed to 180 10 0 F100 t12
3 N30: feed arc to 126.3961 59.8699 0 center 130 10 0 normal 0 0 1 sweep 94.1334 F100 t49.2881
3 N30: feed arc to 108.2979 68.7473 0 center 124.9545 79.8179 0 normal 0 0 1 sweep -60.5237 F100 t12.6761
4 N40: feed arc to 90 87.446 0 center 50 30 0 normal 0 0 1 sweep 21.5406 F100 t15.7901
5 N50: rapid to 90 100 0 t0.0502
6: event end code="M30"
end of program: 6 blocks, 6 motions, 0 errors, 0 warnings
