=== about
proves: nct-17.3.1-LL
=== main
G17 G90 G41 D0
G0 X90 Y10
N10 G1 X50 Y33.094 ,C10 F100
N20 X10 Y20 ,A225
G0 X90 Y10
N10 G1 ,A150 ,R10
N20 X10 Y20 ,A225
G40 G0 X0 Y30
M30
=== truth
90 10 0
41.6025 37.9423 0
25.8712 35.8712 0
10 20 0
90 10 0
39.5875 39.1056 0
27.5165 37.5165 0 center 34.5875 30.4454 0
10 20 0
0 30 0
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 90 10 0 t0.36
3 N10: feed to 41.6025 37.9423 0 F100 t33.5307
3 N10: feed to 25.8712 35.8712 0 F100 t9.5202
4 N20: feed to 10 20 0 F100 t13.4672
5: rapid to 90 10 0 t0.32
6 N10: feed to 39.5875 39.1057 0 F100 t34.9268
6 N10: feed arc to 27.5165 37.5165 0 center 34.5875 30.4454 0 normal 0 0 1 sweep 75 F100 t7.854
7 N20: feed to 10 20 0 F100 t14.8632
8: rapid to 0 30 0 t0.04
9: event end code="M30"
end of program: 9 blocks, 9 motions, 0 errors, 0 warnings
