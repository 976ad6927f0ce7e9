=== about
proves: nct-17.3-overdet
=== main
G41 D0 G0 X30 F100
G1 ,A45
X90 Y30
G40 X0
M30
=== says
main.nc:2:1: error[nct-contour]
=== expect
file 0 main.nc
main.nc:2:1: error[nct-contour]: a line given by ,A alone needs a block behind it whose line or circle meets it
    G1 ,A45
    ^~~~~~~
alarm: 3 blocks, 0 motions, 1 errors, 0 warnings
