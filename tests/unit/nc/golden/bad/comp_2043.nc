=== about
proves: nct-15.5.3-2043
=== settings
D1 = 2
=== main
G0 X-20 F100
G41 G1 X0 D1
G1 X10
G40 G2 X20 Y-10 R10
M30
=== says
error[nct-2043]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -20 0 0 t0.08
main.nc:4:1: error[nct-2043]: G40 in circular interpolation
    G40 G2 X20 Y-10 R10
    ^~~~~~~~~~~~~~~~~~~
alarm: 4 blocks, 1 motions, 1 errors, 0 warnings
