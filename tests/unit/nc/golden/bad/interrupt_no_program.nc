=== settings
N1758.USD = 1
=== main
M96
M30
=== says
main.nc:1:1: error[nct-2004]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2004]: missing data P: M96 needs a program number or a file name
    M96
    ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
