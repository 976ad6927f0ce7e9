G54.1 X0
M30
=== says
main.nc:1:1: error[nct-2004]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2004]: missing data P: G54.1 needs P1 to P99
    G54.1 X0
    ^~~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
