=== about
proves: nct-17.1-large
=== main
G17 G1 Y40 ,C10 F100
X60 ,R22
G3 X20 Y80 R40 ,C10
G1 Y110
M30
=== says
main.nc:2:1: error[nct-corner-too-large]
=== expect
file 0 main.nc
1: feed from 0 0 0 to 0 30 0 F100 t18
1: feed to 10 40 0 F100 t8.4853
main.nc:2:1: error[nct-corner-too-large]: chamfer or rounding too large: it does not fit the two blocks
    X60 ,R22
    ^~~~~~~~
alarm: 3 blocks, 2 motions, 1 errors, 0 warnings
