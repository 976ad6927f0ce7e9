=== about
proves: nct-16.4-order
=== main
G17 G90 G0 X0 Y0
G68 X0 Y0 R30
G51 X0 Y0 P2
G69
M30
=== says
main.nc:4:1: error[nct-transform-order]
=== expect
file 0 main.nc
main.nc:4:1: error[nct-transform-order]: G69: of G68 and G51 the one that came last has to be ended first
    G69
    ^~~
alarm: 4 blocks, 0 motions, 1 errors, 0 warnings
