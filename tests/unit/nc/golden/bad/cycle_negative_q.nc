G0 Z10
G83 X5 Z-5 R2 Q-1 F100
M30
=== says
main.nc:2:15: error[nct-2002]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 10 t0.04
main.nc:2:15: error[nct-2002]: Q data out of range: must not be negative
    G83 X5 Z-5 R2 Q-1 F100
                  ^~~
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings
