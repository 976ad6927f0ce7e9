M-3
M30
=== says
main.nc:1:1: error[nct-2002]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2002]: M data out of range: no minus sign here
    M-3
    ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
