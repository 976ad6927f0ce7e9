G0 X#1
M30
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2123]: macro variables and expressions are not supported
    G0 X#1
       ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
