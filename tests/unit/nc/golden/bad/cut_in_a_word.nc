G0 X1
G1 X2 F
=== says
main.nc:2:7: error[nct-2064]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 0 t0.004
main.nc:2:7: error[nct-2064]: syntax error: F has no value
    G1 X2 F
          ^
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings
