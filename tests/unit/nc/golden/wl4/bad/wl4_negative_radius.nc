=== about
An arc inside that is smaller than the tool stops the program.
Truth: the centre stops at 2', the end of the block before the arc (manual, 6.2.1).
proves: wl4-6.2.1-negr
=== settings
control = wl4-mill
D1 = 8
=== main
%R
G54 G0 X0 Y-10
G41 D1 G1 X10 F100
Y10
G3 X4 Y16 R6
M30
%
=== truth
rapid 0 -10 0
feed 2 -10 0 F 100 t 1.2
feed 2 10 0 F 100 t 12
=== says
main.nc:5:1: error[wl4-negative-radius]: negative radius under compensation
alarm:
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 0 -10 0 t0.04
3: feed to 2 -10 0 F100 t1.2
4: feed to 2 10 0 F100 t12
main.nc:5:1: error[wl4-negative-radius]: negative radius under compensation: the arc is smaller than the tool
    G3 X4 Y16 R6
    ^~~~~~~~~~~~
alarm: 4 blocks, 3 motions, 1 errors, 0 warnings
