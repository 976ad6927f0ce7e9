G1 X1 F0.0000000001
M30
=== says
main.nc:1:7: error[nct-2002]
=== expect
file 0 main.nc
main.nc:1:7: error[nct-2002]: F data out of range: at least 0.000001
    G1 X1 F0.0000000001
          ^~~~~~~~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
