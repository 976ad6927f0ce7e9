=== main
DO1
DO1
END1
M30
=== says
error[nct-2064]
=== expect
file 0 main.nc
main.nc:2:1: error[nct-2064]: syntax error: DO1 inside DO1
    DO1
    ^~~
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings
