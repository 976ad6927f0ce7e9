=== about
Start-up right before G40, before an arc behind a block without motion, and G38 on an arc.
proves: nct-15.5.1-G41 nct-15.5.1-noaxis nct-15.5.5-G38
=== settings
D1 = 5
=== main
G0 X-50
G41 G1 X0 Y0 D1 F100
G40 X50 Y50
G0 X-50 Y0
G1 G41 D1
G3 X-30 Y20 J20
G1 Y40
Y60
G40 X0
G0 X-50 Y0
G1 G41 D1 X0
G38 G3 X20 Y20 J20
G1 Y40
G40 X0
M30
=== truth
-50 0 0
0 5 0
50 50 0
-50 0 0
-50 5 0
-35 20 0 center -50 20 0 sweep 90
-35 40 0
* * 0
0 60 0
-50 0 0
0 5 0
20 25 0 center 0 20 0
15 40 0
0 40 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -50 0 0 t0.2
2: feed to 0 5 0 F100 t30.1496
3: feed to 50 50 0 F100 t40.3609
4: rapid to -50 0 0 t0.4
6: feed to -50 5 0 F100 t3
6: feed arc to -35 20 0 center -50 20 0 normal 0 0 1 sweep 90 F75 t18.8496
7: feed to -35 40 0 F100 t12
8: feed to -35 65 0 F100 t15
9: feed to 0 60 0 F100 t21.2132
10: rapid to -50 0 0 t0.24
11: feed to 0 5 0 F100 t30.1496
12: feed arc to 20 25 0 center 0 20 0 normal 0 0 1 sweep 104.0362 F100 t19.6937
13: feed to 15 40 0 F100 t9.4868
14: feed to 0 40 0 F100 t9
15: event end code="M30"
end of program: 15 blocks, 14 motions, 0 errors, 0 warnings
