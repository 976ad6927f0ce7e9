=== about
proves: nct-17.1-2085
=== main
G1 X30 ,R5 F100
G18
X20 Z20
M30
=== says
error[nct-2085]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2085]: illegal chamfer or rounding: both blocks have to lie in the selected plane
    G1 X30 ,R5 F100
    ^~~~~~~~~~~~~~~
alarm: 3 blocks, 0 motions, 1 errors, 0 warnings
