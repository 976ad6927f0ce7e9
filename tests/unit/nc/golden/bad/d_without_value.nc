G0 X1
G41 X5 D
M30
=== says
main.nc:2:8: error[nct-2064]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 0 t0.004
main.nc:2:8: error[nct-2064]: syntax error: D has no value
    G41 X5 D
           ^
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings
