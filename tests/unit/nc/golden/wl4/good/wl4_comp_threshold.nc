=== about
Corners whose compensated ends are nearer to each other than DELT_L get no arc; inside a step that is too short for the tool the path gouges without an error.
proves: wl4-6.2-DeltL wl4-6.2.1-gouge
=== settings
control = wl4-mill
D1 = 2
param.DELT_L = 0.5
=== main
%THRESHOLD
G54 G0 X-10 Y0
G41 D1 G1 X0 F100
X20
X40 Y-2
G40 Y-10
G0 X0 Y0
G42 D1 G1 X10 Y10
X30
Y11
X50
G40 Y0
M30
%
=== truth
rapid -10 0 0
feed 0 2 0
feed 20 2 0
feed 40.199 -0.0099 0
feed 40 -10 0
rapid 0 0 0
feed 10 8 0
feed 30 8 0
feed 32 10 0 center 30 10 0
feed 32 9 0
feed 50 9 0
feed 50 0 0
=== expect
file 0 main.nc
2: rapid from 0 0 0 to -10 0 0 t0.04
3: feed to 0 2 0 F100 t6.1188
4: feed to 20 2 0 F100 t12
5: feed to 40.199 -0.0099 0 F100 t12.1793
6: feed to 40 -10 0 F100 t5.9952
7: rapid to 0 0 0 t0.16
8: feed to 10 8 0 F100 t7.6837
9: feed to 30 8 0 F100 t12
9: feed arc to 32 10 0 center 30 10 0 normal 0 0 1 sweep 90 F100 t1.885
10: feed to 32 9 0 F100 t0.6
11: feed to 50 9 0 F100 t10.8
12: feed to 50 0 0 F100 t5.4
13: event end code="M30"
end of program: 12 blocks, 12 motions, 0 errors, 0 warnings
