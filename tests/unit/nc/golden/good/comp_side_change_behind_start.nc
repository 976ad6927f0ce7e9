=== about
A change of side in the block right behind the start-up: it acts from the start of its block, so that the tool starts on the new side.
The same by an offset of the other sign.
proves: nct-15.5.4-change nct-15.5-negR
=== settings
D1 = 5
D2 = -5
=== main
G0 X-50
G41 D1 G1 X0 F100
G42 X20 Y0
X40
G40 X60
G0 X-50
G41 D1 G1 X0
X20 Y0 D2
X40
G40 X60
G0 X-50
G41 D1 G1 X0
G42 Y20
Y40
G40 X40
M30
=== truth
-50 0 0
0 -5 0
20 -5 0
40 -5 0
60 0 0
-50 0 0
0 -5 0
20 -5 0
40 -5 0
60 0 0
-50 0 0
5 -5 0
5 20 0
5 40 0
40 40 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -50 0 0 t0.2
2: feed to 0 -5 0 F100 t30.1496
3: feed to 20 -5 0 F100 t12
4: feed to 40 -5 0 F100 t12
5: feed to 60 0 0 F100 t12.3693
6: rapid to -50 0 0 t0.44
7: feed to 0 -5 0 F100 t30.1496
8: feed to 20 -5 0 F100 t12
9: feed to 40 -5 0 F100 t12
10: feed to 60 0 0 F100 t12.3693
11: rapid to -50 0 0 t0.44
12: feed to 5 -5 0 F100 t33.1361
13: feed to 5 20 0 F100 t15
14: feed to 5 40 0 F100 t12
15: feed to 40 40 0 F100 t21
16: event end code="M30"
end of program: 16 blocks, 15 motions, 0 errors, 0 warnings
