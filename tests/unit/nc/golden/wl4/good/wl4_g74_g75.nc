=== about
Digest wl4, 9.7: the two tests of G74 and G75.
proves: wl4-11.6-G74 wl4-11.7-G75
=== settings
control = wl4-lathe
=== main
%GROOVES
G54 G95
G0 X60 Z1
G74 X40 Z-5 F0.1 #1=8
G0 X62 Z-6
G75 X40 Z-20 F0.1 #1=4
M30
%
=== truth
rapid 30 0 1
feed 30 0 -5
rapid 30 0 1
rapid 26 0 1
feed 26 0 -5
rapid 26 0 1
rapid 22 0 1
feed 22 0 -5
rapid 22 0 1
rapid 20 0 1
feed 20 0 -5
rapid 20 0 1
rapid 31 0 -6
feed 20 0 -6
rapid 31 0 -6
rapid 31 0 -10
feed 20 0 -10
rapid 31 0 -10
rapid 31 0 -14
feed 20 0 -14
rapid 31 0 -14
rapid 31 0 -18
feed 20 0 -18
rapid 31 0 -18
rapid 31 0 -20
feed 20 0 -20
rapid 31 0 -20
=== expect
file 0 main.nc
3: rapid from 0 0 0 to 30 0 1 t0.12
file 1 %1
%1:130:1: warning[wl4-spindle-off]: feed per revolution while the spindle stands: timed at 1000 1/min
    N07407 G1 W#24
    ^~~~~~~~~~~~~~
    note: called from main.nc:4
1/130 N7407 depth 1: feed to 30 0 -5 F100 t3.6
1/131 depth 1: rapid to 30 0 1 t0.024
1/129 N7406 depth 1: rapid to 26 0 1 t0.016
1/130 N7407 depth 1: feed to 26 0 -5 F100 t3.6
1/131 depth 1: rapid to 26 0 1 t0.024
1/129 N7406 depth 1: rapid to 22 0 1 t0.016
1/130 N7407 depth 1: feed to 22 0 -5 F100 t3.6
1/131 depth 1: rapid to 22 0 1 t0.024
1/129 N7406 depth 1: rapid to 20 0 1 t0.008
1/130 N7407 depth 1: feed to 20 0 -5 F100 t3.6
1/131 depth 1: rapid to 20 0 1 t0.024
5: rapid to 31 0 -6 t0.044
1/144 N7507 depth 1: feed to 20 0 -6 F100 t6.6
1/145 depth 1: rapid to 31 0 -6 t0.044
1/143 N7506 depth 1: rapid to 31 0 -10 t0.016
1/144 N7507 depth 1: feed to 20 0 -10 F100 t6.6
1/145 depth 1: rapid to 31 0 -10 t0.044
1/143 N7506 depth 1: rapid to 31 0 -14 t0.016
1/144 N7507 depth 1: feed to 20 0 -14 F100 t6.6
1/145 depth 1: rapid to 31 0 -14 t0.044
1/143 N7506 depth 1: rapid to 31 0 -18 t0.016
1/144 N7507 depth 1: feed to 20 0 -18 F100 t6.6
1/145 depth 1: rapid to 31 0 -18 t0.044
1/143 N7506 depth 1: rapid to 31 0 -20 t0.008
1/144 N7507 depth 1: feed to 20 0 -20 F100 t6.6
1/145 depth 1: rapid to 31 0 -20 t0.044
7: event end code="M30"
end of program: 48 blocks, 27 motions, 0 errors, 1 warnings
