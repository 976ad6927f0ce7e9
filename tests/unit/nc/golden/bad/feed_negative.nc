G1 X10 F-5
M30
=== says
main.nc:1:8: error[nct-2002]
=== expect
file 0 main.nc
main.nc:1:8: error[nct-2002]: F takes no minus sign
    G1 X10 F-5
           ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
