#1=5
G0 X#1
M30
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2123]: macro variables and expressions are not supported
    #1=5
    ^~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
