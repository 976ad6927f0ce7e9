G68 X0 Y0 R30
M30
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2123]: function not implemented: G68 (rotation in the plane) is not supported
    G68 X0 Y0 R30
    ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
