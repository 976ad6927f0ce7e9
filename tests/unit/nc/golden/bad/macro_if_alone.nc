=== main
IF[1EQ1]
M30
=== says
main.nc:1:1: error[nct-2064]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2064]: syntax error: IF without a command
    IF[1EQ1]
    ^~~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
