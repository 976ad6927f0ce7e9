=== about
proves: nct-17.3-overdet
=== main
G41 D0 G0 X30 F100
G1 X90 Y30 ,A45
G40 X0
M30
=== says
main.nc:2:1: error[nct-contour]
=== expect
file 0 main.nc
main.nc:2:1: error[nct-contour]: an over-determined block needs a G1, G2 or G3 block before it, in G41 or G42
    G1 X90 Y30 ,A45
    ^~~~~~~~~~~~~~~
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings
