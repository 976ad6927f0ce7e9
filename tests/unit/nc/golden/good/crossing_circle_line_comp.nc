=== about
Circle and line with a cutter of radius 5: an outer corner of two points.
proves: nct-17.3.3-AL
=== settings
D1 = 5
=== main
N10 G17 G0 X90 Y0
N20 G42 G1 X50 D1 F100
N30 G3 X-50 Y0 R50
N40 G1 X-50 Y42.857 ,A171.87 Q-1
N50 G40 G0 Y70
M30
=== truth
90 0 0
55 0 0
44 33 0 center 0 0 0
42.7574 34.6569 0
* * 0
-50 70 0
=== expect
file 0 main.nc
1 N10: rapid from 0 0 0 to 90 0 0 t0.36
2 N20: feed to 55 0 0 F100 t21
3 N30: feed arc to 44 33 0 center 0 0 0 normal 0 0 1 sweep 36.8699 F100 t21.2356
3 N30: feed to 42.7573 34.6569 0 F100 t1.2426
4 N40: feed to -49.2929 47.8067 0 F100 t55.7909
5 N50: rapid to -50 70 0 t0.0888
6: event end code="M30"
end of program: 6 blocks, 6 motions, 0 errors, 0 warnings
