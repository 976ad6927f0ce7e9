G65 P10
M30
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2123]: function not implemented: G65 (macro call) is not supported
    G65 P10
    ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
