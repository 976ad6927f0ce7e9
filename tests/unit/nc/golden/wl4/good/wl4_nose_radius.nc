=== about
The nose centre keeps Rt + D off the contour; the path is told at the touch-off point, tip 3: 0.8 below the centre in X and Z.
proves: wl4-6.1-Rt wl4-7.3-T wl4-7.3-T0 wl4-9.2-121
=== settings
control = wl4-lathe
param.RT.1 = 0.8
param.TIP.1 = 3
param.RT.2 = 0.4
param.POINT_S.2 = 1
D1 = 0.2
=== main
%NOSE
G54 G94 F100
T1 G0 X40 Z10
G41 D0 G1 X20
Z-20
G40 X50
G41 D1 G0 X20 Z10
G1 Z-10
G40 G0 X50
T2 G0 X40 Z10
G41 D0 G1 X20
Z-20
G40 X#121
T0 X50
M30
%
=== truth
rapid 20 0 10
feed 10 0 9.2
feed 10 0 -20.8
feed 25 0 -20
rapid 10.2 0 9.2
feed 10.2 0 -10.8
rapid 25 0 -10
rapid 20 0 10
feed 10.4 0 10
feed 10.4 0 -20
feed 1 0 -20
feed 25 0 -20
=== expect
file 0 main.nc
3: rapid from 0 0 0 to 20 0 10 t0.08
4: feed to 10 0 9.2 F100 t6.0192
5: feed to 10 0 -20.8 F100 t18
6: feed to 25 0 -20 F100 t9.0128
7: rapid to 10.2 0 9.2 t0.1168
8: feed to 10.2 0 -10.8 F100 t12
9: rapid to 25 0 -10 t0.0592
10: rapid to 20 0 10 t0.08
11: feed to 10.4 0 10 F100 t5.76
12: feed to 10.4 0 -20 F100 t18
13: feed to 1 0 -20 F100 t5.64
14: feed to 25 0 -20 F100 t14.4
15: event end code="M30"
end of program: 14 blocks, 12 motions, 0 errors, 0 warnings
