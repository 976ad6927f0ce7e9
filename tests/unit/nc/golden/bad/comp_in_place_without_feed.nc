=== settings
D1 = 5
=== main
G0 X-10
G1 G41 D1
M30
=== says
main.nc:2:1: error[nct-feed]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -10 0 0 t0.04
main.nc:2:1: error[nct-feed]: no feed is programmed: a feed motion needs F
    G1 G41 D1
    ^~~~~~~~~
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings
