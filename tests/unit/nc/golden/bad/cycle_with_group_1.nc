G0 G81 X5 Z-5 R2 F100
M30
=== says
main.nc:1:1: error[nct-group-clash]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-group-clash]: G0 and G81 cannot stand in one block
    G0 G81 X5 Z-5 R2 F100
    ^~~~~~~~~~~~~~~~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
