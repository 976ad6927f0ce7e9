=== about
proves: nct-17.1-2085
=== main
G1 ,C5 F100
M30
=== says
error[nct-2085]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2085]: illegal chamfer or rounding: the block does not move in the plane
    G1 ,C5 F100
       ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
