=== main
M98 P11
M30
=== sub O0011.nc
M98 P12
M99
=== sub O0012.nc
G0 X1
G777
M99
=== says
O0012.nc:2:1: error[nct-2123]
=== expect
file 0 main.nc
file 1 O0011.nc
file 2 O0012.nc
2/1 depth 2: rapid from 0 0 0 to 1 0 0 t0.004
O0012.nc:2:1: error[nct-2123]: function not implemented: G777 is not a code of this control
    G777
    ^~~~
    note: called from O0011.nc:1 by M98
    note: called from main.nc:1 by M98
alarm: 4 blocks, 1 motions, 1 errors, 0 warnings
