=== about
proves: nct-17.3.5-chain
=== settings
D1 = 0
=== main
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
230 20 0
199.7612 35.1194 0
135.7571 87.9285 0 center 150 40 0 sweep 112.1521
61.0208 78.9792 0 center 100 70 0 sweep 140.3987
32 108 0
10 108 0
10 130 0
240 130 0
=== expect
file 0 main.nc
1 N10: event spindle rpm=500 direction="cw"
1 N10: rapid from 0 0 0 to 230 20 0 t0.92
2 N20: feed to 199.7612 35.1194 0 F300 t6.7616
3 N30: feed arc to 135.7571 87.9285 0 center 150 40 0 normal 0 0 1 sweep 112.1521 F300 t19.5742
4 N40: feed arc to 61.0208 78.9792 0 center 100 70 0 normal 0 0 1 sweep 140.3987 F300 t19.6034
5 N50: feed to 32 108 0 F300 t8.2083
6 N60: feed to 10 108 0 F300 t4.4
7 N70: rapid to 10 130 0 t0.088
8 N80: rapid to 240 130 0 t0.92
9: event end code="M30"
end of program: 9 blocks, 8 motions, 0 errors, 0 warnings
