M98 P77
M30
=== says
main.nc:1:1: error[nct-2147]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2147]: file not found: program O0077 is not among the programs given
    M98 P77
    ^~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
