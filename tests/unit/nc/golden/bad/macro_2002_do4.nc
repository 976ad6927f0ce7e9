=== main
DO4
END4
M30
=== says
error[nct-2002]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2002]: DO data out of range: loops have the numbers 1 to 3
    DO4
    ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
