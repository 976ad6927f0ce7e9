=== about
Digest wl4, 4.3 and 4.4: both forms of the arc, quarter circles, full circle, helix.
proves: wl4-5.1.3-G2 wl4-5.1.3-R wl4-5.1.3-full wl4-5.1.4-G12 wl4-5.1.4-G13 wl4-5.1.3-G3 wl4-4.2-IJK wl4-4.2-R wl4-5.7-G17 wl4-5.7-G19 wl4-5.10-G54 wl4-5.1.1-G0 wl4-5.1.2-G1 wl4-5.8-G90
=== settings
control = wl4-mill
=== main
%ARC
G90G54G17G1X-50Y86.603F100
G2X0Y100I50J-86.603
G1X-50Y86.603
G2X0Y100R100
G12X100Y0F100
G0X0Y100
G13X100Y0
G0X10Y0
G3I-10J0
G2Z5I-10J0
G19 G0 X0 Y10 Z0
G3 Y0 Z10 J-10 K0
M30
%
=== truth
feed -50 86.603 0
feed 0 100 0 center 0 0 0 sweep -29.9999
feed -50 86.603 0
feed 0 100 0 center -0.0008 0 0 sweep -29.9999
feed 100 0 0 center 0 0 0 sweep -90
rapid 0 100 0
feed 100 0 0 center 100 100 0 sweep 90
rapid 10 0 0
feed 10 0 0 center 0 0 0 sweep 360
feed 10 0 5 center 0 0 0 sweep -360
rapid 0 10 0
feed 0 0 10 center 0 0 0 sweep 90
=== expect
file 0 main.nc
2: feed from 0 0 0 to -50 86.603 0 F100 t60.0002
3: feed arc to 0 100 0 center 0 0 0 normal 0 0 1 sweep -29.9999 F100 t31.4159
4: feed to -50 86.603 0 F100 t31.0582
5: feed arc to 0 100 0 center -0.0008 0 0 normal 0 0 1 sweep -29.9999 F100 t31.4159
6: feed arc to 100 0 0 center 0 0 0 normal 0 0 1 sweep -90 F100 t94.2478
7: rapid to 0 100 0 t0.4
8: feed arc to 100 0 0 center 100 100 0 normal 0 0 1 sweep 90 F100 t94.2478
9: rapid to 10 0 0 t0.36
10: feed arc to 10 0 0 center 0 0 0 normal 0 0 1 sweep 360 F100 t37.6991
11: feed arc to 10 0 5 center 0 0 0 normal 0 0 1 sweep -360 F100 t37.8183
12: rapid to 0 10 0 t0.04
13: feed arc to 0 0 10 center 0 0 0 normal 1 0 0 sweep 90 F100 t9.4248
14: event end code="M30"
end of program: 13 blocks, 12 motions, 0 errors, 0 warnings
