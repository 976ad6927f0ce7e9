G10 P1 X5
M30
=== says
main.nc:1:1: error[nct-2004]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2004]: missing data L: G10 needs L
    G10 P1 X5
    ^~~~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
