G1 X10
M30
=== says
main.nc:1:1: error[nct-feed]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-feed]: no feed is programmed: a feed motion needs F
    G1 X10
    ^~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
