=== about
Digest wl4, 9.6: the two tests of G72 and G73.
proves: wl4-11.4-G72 wl4-11.5-G73
=== settings
control = wl4-lathe
=== main
%PECK
G54 G95
G0 X54 Z-10
G72 X34 W6 F0.1 #1=6 #2=1
G0 X0 Z2
G73 U4 Z-23 F0.1 #1=10 #2=1
M30
%
=== truth
rapid 27 0 -10
feed 24 0 -10
rapid 27 0 -10
rapid 24.5 0 -10
feed 21 0 -10
rapid 27 0 -10
rapid 21.5 0 -10
feed 18 0 -10
rapid 27 0 -10
rapid 18.5 0 -10
feed 17 0 -10
rapid 27 0 -10
rapid 27 0 -4
rapid 0 0 2
feed 0 0 -8
rapid 0 0 2
rapid 0 0 -7
feed 0 0 -18
rapid 0 0 2
rapid 0 0 -17
feed 0 0 -23
rapid 0 0 2
rapid 2 0 2
=== expect
file 0 main.nc
3: rapid from 0 0 0 to 27 0 -10 t0.108
file 1 %1
%1:93:8: warning[wl4-spindle-off]: feed per revolution while the spindle stands: timed at 1000 1/min
           #20=0 #21=#1 G1 U(#21*#3)  N7207
           ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
    note: called from main.nc:4
1/93 depth 1: feed to 24 0 -10 F100 t1.8
1/96 N7207 depth 1: rapid to 27 0 -10 t0.012
1/94 N7206 depth 1: rapid to 24.5 0 -10 t0.01
1/95 depth 1: feed to 21 0 -10 F100 t2.1
1/96 N7207 depth 1: rapid to 27 0 -10 t0.024
1/94 N7206 depth 1: rapid to 21.5 0 -10 t0.022
1/95 depth 1: feed to 18 0 -10 F100 t2.1
1/96 N7207 depth 1: rapid to 27 0 -10 t0.036
1/94 N7206 depth 1: rapid to 18.5 0 -10 t0.034
1/95 depth 1: feed to 17 0 -10 F100 t0.9
1/96 N7207 depth 1: rapid to 27 0 -10 t0.04
1/99 depth 1: rapid to 27 0 -4 t0.024
5: rapid to 0 0 2 t0.108
1/112 depth 1: feed to 0 0 -8 F100 t6
1/115 N7307 depth 1: rapid to 0 0 2 t0.04
1/113 N7306 depth 1: rapid to 0 0 -7 t0.036
1/114 depth 1: feed to 0 0 -18 F100 t6.6
1/115 N7307 depth 1: rapid to 0 0 2 t0.08
1/113 N7306 depth 1: rapid to 0 0 -17 t0.076
1/114 depth 1: feed to 0 0 -23 F100 t3.6
1/115 N7307 depth 1: rapid to 0 0 2 t0.1
1/118 depth 1: rapid to 2 0 2 t0.008
7: event end code="M30"
end of program: 38 blocks, 23 motions, 0 errors, 1 warnings
