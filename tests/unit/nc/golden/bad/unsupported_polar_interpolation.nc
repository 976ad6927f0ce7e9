G12.1
M30
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2123]: function not implemented: G12.1 (polar interpolation) is not supported
    G12.1
    ^~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
