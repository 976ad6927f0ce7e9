G54.12 X2
M30
=== says
main.nc:1:1: error[nct-2123]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2123]: function not implemented: G54.12 is not a code of this control
    G54.12 X2
    ^~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
