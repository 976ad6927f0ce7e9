G0 X1
G123 X2
M30
=== says
main.nc:2:1: error[nct-2123]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 0 t0.004
main.nc:2:1: error[nct-2123]: function not implemented: G123 is not a code of this control
    G123 X2
    ^~~~
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings
