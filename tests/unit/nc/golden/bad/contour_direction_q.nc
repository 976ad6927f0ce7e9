=== about
proves: nct-17.2-A
=== main
G1 X30 ,A30 Q1 F100
M30
=== says
main.nc:1:13: error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:13: error[nct-2017]: illegal address Q: Q belongs to the intersection with the block before
    G1 X30 ,A30 Q1 F100
                ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
