=== about
proves: nct-17.1-2085
=== main
G1 X30 ,R5 F100
Z20
M30
=== says
error[nct-2085]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2085]: illegal chamfer or rounding: no G1, G2 or G3 block in the plane follows
    G1 X30 ,R5 F100
    ^~~~~~~~~~~~~~~
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings
