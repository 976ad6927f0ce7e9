=== main
#3101=3
M30
=== says
error[nct-2161]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2161]: variable #3101 is read-only
    #3101=3
    ^~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
