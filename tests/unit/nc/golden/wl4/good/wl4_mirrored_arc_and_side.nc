=== about
In a mirrored plane clockwise becomes counter-clockwise and left becomes right.
proves: wl4-5.11-G51 wl4-6.2-G41
=== settings
control = wl4-mill
D1 = 2
=== main
%MIRROR
G54 G51 X-1
G0 X10 Y0
G2 X0 Y-10 I-10 J0 F100
G0 X20 Y-20
G41 D1 G1 X10
Y10
G40 X20
M30
%
=== truth
rapid -10 0 0
feed 0 -10 0 center 0 0 0 sweep 90
rapid -20 -20 0
feed -8 -20 0
feed -8 10 0
feed -20 10 0
=== expect
file 0 main.nc
3: rapid from 0 0 0 to -10 0 0 t0.04
4: feed arc to 0 -10 0 center 0 0 0 normal 0 0 1 sweep 90 F100 t9.4248
5: rapid to -20 -20 0 t0.08
6: feed to -8 -20 0 F100 t7.2
7: feed to -8 10 0 F100 t18
8: feed to -20 10 0 F100 t7.2
9: event end code="M30"
end of program: 8 blocks, 6 motions, 0 errors, 0 warnings
