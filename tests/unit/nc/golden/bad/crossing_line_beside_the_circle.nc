=== about
Line and circle without a common point.
proves: nct-17.3.2-LA
=== main
G17 G42 G0 X100 Y20 D0 F100
G1 X90 Y60
G3 X20 Y40 I20 J-10 R50 Q1
G40 G0 Y60
M30
=== says
error[nct-contour]
=== expect
file 0 main.nc
main.nc:3:1: error[nct-contour]: the block and the one before it have no common point
    G3 X20 Y40 I20 J-10 R50 Q1
    ^~~~~~~~~~~~~~~~~~~~~~~~~~
alarm: 3 blocks, 0 motions, 1 errors, 0 warnings
