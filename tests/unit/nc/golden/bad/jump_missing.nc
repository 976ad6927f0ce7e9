=== main
M98 P11
M30
=== sub O0011.nc
M99 P999
=== says
O0011.nc:1:1: error[nct-2125]
=== expect
file 0 main.nc
file 1 O0011.nc
O0011.nc:1:1: error[nct-2125]: block N999 not found: main.nc
    M99 P999
    ^~~~~~~~
    note: called from main.nc:1 by M98
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings
