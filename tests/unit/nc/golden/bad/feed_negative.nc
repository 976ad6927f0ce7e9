G1 X10 F-5
M30
=== says
main.nc:1:8: error[nct-2002]
=== expect
file 0 main.nc
main.nc:1:8: error[nct-2002]: F data out of range: no minus sign here
    G1 X10 F-5
           ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
