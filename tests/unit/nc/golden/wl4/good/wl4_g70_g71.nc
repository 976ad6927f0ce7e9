=== about
Digest wl4, 9.5: the four tests of G70 and G71.
proves: wl4-11.2-G70 wl4-11.3-G71 wl4-4.2-UVW
=== settings
control = wl4-lathe
=== main
%STEPS
G54 G95
G0 X50 Z2
G70 X30 Z-40 F0.2 #1=10 #2=8
G0 X20 Z2
G70 X30 Z-40 F0.2 #1=10 #2=8
G0 X52 Z2
G71 X30 Z-10 F0.2 #1=8 #2=4
G0 X10 Z2
G71 U22 W8 F0.2 #1=8 #2=4
M30
%
=== truth
rapid 25 0 2
rapid 15 0 2
feed 15 0 -30
feed 21 0 -40
feed 25 0 -40
rapid 25 0 2
rapid 10 0 2
rapid 15 0 2
feed 15 0 -30
feed 14 0 -40
feed 10 0 -40
rapid 10 0 2
rapid 26 0 2
rapid 26 0 -10
feed 19 0 -10
feed 15 0 -2
feed 15 0 2
rapid 26 0 2
rapid 5 0 2
rapid 5 0 10
feed 12 0 10
feed 16 0 6
feed 16 0 2
rapid 5 0 2
=== expect
file 0 main.nc
3: rapid from 0 0 0 to 25 0 2 t0.1
file 1 %1
1/59 depth 1: rapid to 15 0 2 t0.04
%1:60:8: warning[wl4-spindle-off]: feed per revolution while the spindle stands: timed at 1000 1/min
           G1 W(#24-#1)
           ^~~~~~~~~~~~
    note: called from main.nc:4
1/60 depth 1: feed to 15 0 -30 F200 t9.6
1/61 depth 1: feed to 21 0 -40 F200 t3.4986
1/62 depth 1: feed to 25 0 -40 F200 t1.2
1/63 depth 1: rapid to 25 0 2 t0.168
5: rapid to 10 0 2 t0.06
1/59 depth 1: rapid to 15 0 2 t0.02
1/60 depth 1: feed to 15 0 -30 F200 t9.6
1/61 depth 1: feed to 14 0 -40 F200 t3.015
1/62 depth 1: feed to 10 0 -40 F200 t1.2
1/63 depth 1: rapid to 10 0 2 t0.168
7: rapid to 26 0 2 t0.064
1/76 depth 1: rapid to 26 0 -10 t0.048
1/77 depth 1: feed to 19 0 -10 F200 t2.1
1/78 depth 1: feed to 15 0 -2 F200 t2.6833
1/79 depth 1: feed to 15 0 2 F200 t1.2
1/80 depth 1: rapid to 26 0 2 t0.044
9: rapid to 5 0 2 t0.084
1/76 depth 1: rapid to 5 0 10 t0.032
1/77 depth 1: feed to 12 0 10 F200 t2.1
1/78 depth 1: feed to 16 0 6 F200 t1.6971
1/79 depth 1: feed to 16 0 2 F200 t1.2
1/80 depth 1: rapid to 5 0 2 t0.044
11: event end code="M30"
end of program: 43 blocks, 24 motions, 0 errors, 1 warnings
