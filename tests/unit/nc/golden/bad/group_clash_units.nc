G20 G21
M30
=== says
main.nc:1:5: error[nct-group-clash]
=== expect
file 0 main.nc
main.nc:1:5: error[nct-group-clash]: G20 and G21 are of one group
    G20 G21
        ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
