=== about
Working point S and the shifts dXw, dZw (manual, 6.1). The path is told at the touch-off point of the insert: tool 2
moves its nose centre, 0.4 in X and Z beyond that point. Shifts count from T on, and T0 ends them; a gauge says what
they make up for. DXW.3 is 0.5 more than the gauge: all of tool 3 lies 0.5 too far out.
proves: wl4-6.1-wp
=== settings
control = wl4-lathe
param.RT.2 = 0.4
param.POINT_S.2 = 1
insert2 = 0.4 0.4
param.DXW.3 = 50.5
param.DZW.3 = 30
insert3 = 0.8 0.8 50 30
param.DXW.4 = 2
param.DZW.4 = -1
=== main
%POINT
G54 G94 F100
T2 M6
G0 X60 Z5
G41 D0 G1 X50
Z-20
G40 X60
T3 M6
G0 X60 Z5
G1 X50
Z-20
T4
G0 X60 Z5
T0
X60 Z5
M30
%
=== truth
rapid 29.6 0 4.6
feed 25 0 4.6
feed 25 0 -20.4
feed 29.6 0 -20.4
rapid 30.5 0 5
feed 25.5 0 5
feed 25.5 0 -20
rapid -18 0 -26
rapid -20 0 -25
=== expect
file 0 main.nc
3: event tool tool=2
4: rapid from -0.4 0 -0.4 to 29.6 0 4.6 t0.12
5: feed to 25 0 4.6 F100 t2.76
6: feed to 25 0 -20.4 F100 t15
7: feed to 29.6 0 -20.4 F100 t2.76
8: event tool tool=3
9: rapid from -20 0 -50 to 30.5 0 5 t0.22
10: feed to 25.5 0 5 F100 t3
11: feed to 25.5 0 -20 F100 t15
13: rapid to -18 0 -26 t0.174
15: rapid to -20 0 -25 t0.008
16: event end code="M30"
end of program: 15 blocks, 9 motions, 0 errors, 0 warnings
