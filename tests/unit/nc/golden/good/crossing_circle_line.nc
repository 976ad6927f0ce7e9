=== about
proves: nct-17.3.3-AL
=== main
N10 G17 G0 X90 Y0
N20 G42 G1 X50 D0 F100
N30 G3 X-50 Y0 R50
N40 G1 X-50 Y42.857 ,A171.87 Q-1
N50 G40 G0 Y70
N60 X90 Y0
N20 G42 G1 X50 D0
N30 G3 X-50 Y0 R50
N40 G1 X-50 Y42.857 ,A171.87 Q1
N50 G40 G0 Y70
M30
=== truth
90 0 0
50 0 0
40 30 0 center 0 0 0 sweep 36.8699
-50 42.857 0
-50 70 0
90 0 0
50 0 0
-30.0001 39.9999 0 center 0 0 0 sweep 126.8701
-50 42.857 0
-50 70 0
=== expect
file 0 main.nc
1 N10: rapid from 0 0 0 to 90 0 0 t0.36
2 N20: feed to 50 0 0 F100 t24
3 N30: feed arc to 40 30 0 center 0 0 0 normal 0 0 1 sweep 36.8699 F100 t19.3051
4 N40: feed to -50 42.857 0 F100 t54.5482
5 N50: rapid to -50 70 0 t0.1086
6 N60: rapid to 90 0 0 t0.56
7 N20: feed to 50 0 0 F100 t24
8 N30: feed arc to -30.0001 39.9999 0 center 0 0 0 normal 0 0 1 sweep 126.8701 F100 t66.429
9 N40: feed to -50 42.857 0 F100 t12.1218
10 N50: rapid to -50 70 0 t0.1086
11: event end code="M30"
end of program: 11 blocks, 10 motions, 0 errors, 0 warnings
