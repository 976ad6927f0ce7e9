=== main
G0 X1
D-5
M30
=== sub O0011
M99
=== says
main.nc:2:1: error[nct-2002]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 0 t0.004
main.nc:2:1: error[nct-2002]: D data out of range: no minus sign here
    D-5
    ^~~
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings
