=== about
proves: nct-17.3.2-LA
=== main
N10 G17 G42 G0 X100 Y20 D0 F100
N20 G1 X-30 Y-20
N30 G3 X20 Y40 I20 J-10 R50 Q-1
N40 G40 G0 Y60
N50 X100 Y20
N60 G42 G0 X100 Y20 D0 F100
N20 G1 X-30 Y-20
N30 G3 X20 Y40 I20 J-10 R50 Q1
N40 G40 G0 Y60
M30
=== truth
100 20 0
66.0216 9.5451 0
20 40 0 center 20 -10 0 sweep 66.9894
20 60 0
100 20 0
-29.0486 -19.7073 0
20 40 0 center 20 -10 0 sweep 258.8052
20 60 0
=== expect
file 0 main.nc
1 N10: rapid from 0 0 0 to 100 20 0 t0.4
2 N20: feed to 66.0216 9.5451 0 F100 t21.3303
3 N30: feed arc to 20 40 0 center 20 -10 0 normal 0 0 1 sweep 66.9894 F100 t35.0755
4 N40: rapid to 20 60 0 t0.08
5 N50: rapid to 100 20 0 t0.32
7 N20: feed to -29.0486 -19.7073 0 F100 t81.0116
8 N30: feed arc to 20 40 0 center 20 -10 0 normal 0 0 1 sweep 258.8052 F100 t135.5101
9 N40: rapid to 20 60 0 t0.08
10: event end code="M30"
end of program: 10 blocks, 8 motions, 0 errors, 0 warnings
