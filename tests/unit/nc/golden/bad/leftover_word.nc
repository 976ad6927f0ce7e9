G1 X1 Q5 F100
M30
=== says
main.nc:1:7: error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:7: error[nct-2017]: illegal address Q: Q belongs to the intersection with the block before
    G1 X1 Q5 F100
          ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
