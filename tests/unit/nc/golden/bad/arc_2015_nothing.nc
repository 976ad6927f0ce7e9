=== about
proves: nct-4.3-2015
=== main
G0 X0 Y0 F100
G2 X40 Y30
M30
=== says
error[nct-2015]
=== expect
file 0 main.nc
main.nc:2:1: error[nct-2015]: circle definition error: neither R nor I, J, K is given
    G2 X40 Y30
    ^~~~~~~~~~
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings
