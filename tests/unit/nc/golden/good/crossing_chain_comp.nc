=== about
proves: nct-17.3.5-chain
=== settings
D1 = 5
=== main
N5 G0 X300 Y20
N10 G17 G54 G0 G42 X230 Y20 D1 F300 S500 M3
N20 G1 X170 Y50
N30 G3 X110 Y10 I150 J40 R50 Q-1
N40 X60 Y70 I100 J70 R40 Q1
N50 G1 X80 Y60 ,A135 Q1
N60 X10 Y108 ,A180
N70 G40 G0 Y130
N80 X240
M30
=== truth
300 20 0
232.2361 24.4721 0
204.9674 38.1065 0
138.2363 93.7272 0 center 150 40 0 sweep 104.3231
58.8528 88.2183 0 center 100 70 0 sweep 124.2969
34.0711 113 0
10 113 0
10 130 0
240 130 0
=== expect
file 0 main.nc
1 N5: rapid from 0 0 0 to 300 20 0 t1.2
2 N10: event spindle rpm=500 direction="cw"
2 N10: rapid to 232.2361 24.4721 0 t0.2711
3 N20: feed to 204.9674 38.1065 0 F300 t6.0975
4 N30: feed arc to 138.2363 93.7272 0 center 150 40 0 normal 0 0 1 sweep 104.3231 F300 t20.0286
5 N40: feed arc to 58.8528 88.2183 0 center 100 70 0 normal 0 0 1 sweep 124.2969 F300 t19.5245
6 N50: feed to 34.0711 113 0 F300 t7.0093
7 N60: feed to 10 113 0 F300 t4.8142
8 N70: rapid to 10 130 0 t0.068
9 N80: rapid to 240 130 0 t0.92
10: event end code="M30"
end of program: 10 blocks, 9 motions, 0 errors, 0 warnings
