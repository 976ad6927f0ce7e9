G1 X10 F0
M30
=== says
main.nc:1:8: error[nct-feed]
=== expect
file 0 main.nc
main.nc:1:8: error[nct-feed]: F must be greater than 0
    G1 X10 F0
           ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
