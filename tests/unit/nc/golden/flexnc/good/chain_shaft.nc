=== about
Start block, approach, two contour blocks, end block on a shaft with a nose of 0.8: the nose centre runs on the
equidistant, the inside corner of arc and cone is where both meet.
proves: fnc-3.6-G81.1 fnc-3.6-G81 fnc-1.5b-inner fnc-3.1-contour fnc-3.1-K fnc-3.6-start
=== settings
control = flexnc
start = 100 0 50
param.RT.1 = 0.8
=== main
T1M06D1
S300M03
G99F0.15
G81.1X0Z5
G12X40R15P0C2K1
G77X60A40Y10P0C2K0
G81X100Z100
M02
=== truth
0 0 5
0 0 0.8
5 0 0.8
20.796450 0 -14.665079 center 5 0 -15 sweep 88.785380
30.565685 0 -24.434315
50 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
4: rapid from 100 0 50 to 0 0 5 t0.4
file 1 G12 of line 5
4: feed to 0 0 0.8 F45 t5.6
1/1 depth 1: feed to 5 0 0.8 F45 t6.6667
file 2 G77 of line 6
1/2 depth 1: feed arc to 20.7964 0 -14.6651 center 5 0 -15 normal 0 1 0 sweep 88.7854 F45 t32.6448
2/1 depth 1: feed to 30.5657 0 -24.4343 F45 t18.421
7: rapid to 50 0 100 t0.4977
8: event spindle rpm=0 direction="stop"
8: event end code="M02"
end of program: 8 blocks, 6 motions, 0 errors, 0 warnings
