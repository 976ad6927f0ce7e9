M98
M30
=== says
main.nc:1:1: error[nct-2004]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2004]: missing data P: M98 needs a program number or a file name
    M98
    ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
