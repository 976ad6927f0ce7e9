=== about
proves: nct-17.2-A
=== main
G1 X30 ,A90 F100
M30
=== says
main.nc:1:8: error[nct-contour]
=== expect
file 0 main.nc
main.nc:1:8: error[nct-contour]: a line in this direction never reaches the coordinate
    G1 X30 ,A90 F100
           ^~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
