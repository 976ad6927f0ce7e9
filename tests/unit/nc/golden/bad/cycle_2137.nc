=== settings
N0607.ORI = 0
=== main
G0 Z10
G76 X5 Z-5 R2 F100
M30
=== says
error[nct-2137]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 10 t0.04
main.nc:2:1: error[nct-2137]: G76, G87: the spindle cannot be oriented, N0607.ORI = 0
    G76 X5 Z-5 R2 F100
    ^~~~~~~~~~~~~~~~~~
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings
