=== about
proves: nct-4.3-2015
=== main
G0 X0 Y0 F100
G2 Z5 R5
M30
=== says
error[nct-2015]
=== expect
file 0 main.nc
main.nc:2:1: error[nct-2015]: circle definition error: R needs an end point in the plane
    G2 Z5 R5
    ^~~~~~~~
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings
