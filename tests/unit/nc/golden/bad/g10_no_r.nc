G10 L10 P1
M30
=== says
main.nc:1:1: error[nct-2004]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2004]: missing data R: the value of the offset
    G10 L10 P1
    ^~~~~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
