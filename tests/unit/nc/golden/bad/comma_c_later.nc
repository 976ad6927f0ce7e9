G1 X10 ,C2 F100
Y10
M30
=== expect
file 0 main.nc
main.nc:1:8: error[nct-2123]: function not implemented: ,C is not supported
    G1 X10 ,C2 F100
           ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
