G10 L99 P1
M30
=== says
main.nc:1:5: error[nct-2123]
=== expect
file 0 main.nc
main.nc:1:5: error[nct-2123]: function not implemented: G10 L99 is not supported
    G10 L99 P1
        ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
