=== about
proves: nct-23.4-M96
=== settings
N1758.USD = 1
=== main
M96 P51
M30
=== says
error[nct-2147]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2147]: file not found: program O0051 is not among the programs given
    M96 P51
    ^~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
