=== about
proves: nct-17.3.1-LL
=== main
G41 D0 G1 X30 F100
X60
X90 Y30 ,A0
G40 X0
M30
=== says
main.nc:3:1: error[nct-contour]
=== expect
file 0 main.nc
main.nc:3:1: error[nct-contour]: the block and the one before it have no common point
    X90 Y30 ,A0
    ^~~~~~~~~~~
alarm: 3 blocks, 0 motions, 1 errors, 0 warnings
