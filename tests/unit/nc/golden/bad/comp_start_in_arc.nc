=== about
proves: nct-15.5.1-arc
=== settings
D1 = 2
=== main
G0 X0 Y0 F100
G41 G2 X10 Y10 R10 D1
M30
=== says
main.nc:2:1: error[nct-comp-start-arc]
=== expect
file 0 main.nc
main.nc:2:1: error[nct-comp-start-arc]: G41, G42 cannot be switched on in a G2 or G3 block
    G41 G2 X10 Y10 R10 D1
    ^~~~~~~~~~~~~~~~~~~~~
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings
