G0 G1 X5 F100
M30
=== says
main.nc:1:4: error[nct-group-clash]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-group-clash]: G0 and G1 are of one group
    G0 G1 X5 F100
       ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
