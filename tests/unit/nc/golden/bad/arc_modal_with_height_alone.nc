=== about
A modal arc with a word beside the plane alone has no definition.
proves: nct-4.3-2015
=== main
G0 X5 F100
G2
Z5
M30
=== says
error[nct-2015]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 5 0 0 t0.02
main.nc:3:1: error[nct-2015]: circle definition error: neither R nor I, J, K is given
    Z5
    ^~
alarm: 3 blocks, 1 motions, 1 errors, 0 warnings
