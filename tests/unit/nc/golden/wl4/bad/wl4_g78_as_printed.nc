=== about
TEST_G78 as the manual prints it: its last contour block has no centre while G2 still holds, and G41 puts the
allowance away from the tool.
Truth: group 1 is modal, so that Z40 behind G2 is an arc without a centre; X is a diameter.
=== settings
control = wl4-lathe
=== main
%TEST_G78
G54 G95 S500 M3
N12 G0 X10 Z40
N11 G78 G41 G0 X10 Z5 P120 Q124 R0.5 F0.3
M2
N120 G1 X8.5
N121 G1 X8 Z15
N122 G3 X7 Z20 R10
N123 G2 X5 Z25 R8
N124 Z40
%
=== truth
rapid 5 0 40 S 500
=== says
main.nc:10:1: error[wl4-arc]
alarm:
=== expect
file 0 main.nc
2: event spindle rpm=500 direction="cw"
3 N12: rapid from 0 0 0 to 5 0 40 t0.16
main.nc:10:1: error[wl4-arc]: G2 of an earlier block still holds, and an arc needs its centre (two of I J K) or R; for a line program G1
    N124 Z40
    ^~~~~~~~
alarm: 3 blocks, 1 motions, 1 errors, 0 warnings
