G92 S2000
M30
=== expect
file 0 main.nc
main.nc:1:5: error[nct-2123]: function not implemented: G92 S (speed limit of G96) is not supported
    G92 S2000
        ^~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
