=== about
#3000 with a text alone: 4000.
proves: nct-23.1.8-3000
=== main
G0 X1
#3000=(TEXT)
X2
M30
=== says
error[nct-4000]: TEXT (01400000)
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 0 t0.004
main.nc:2:1: error[nct-4000]: TEXT (01400000)
    #3000=(TEXT)
    ^~~~~~~~~~~~
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings
