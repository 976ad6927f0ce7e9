G0 Z10
G83 X5 Z-500 R2 Q0.0000001 F100
M30
=== says
main.nc:2:1: error[nct-2002]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 10 t0.04
main.nc:2:1: error[nct-2002]: Q data out of range: the peck is too small for this depth
    G83 X5 Z-500 R2 Q0.0000001 F100
    ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings
