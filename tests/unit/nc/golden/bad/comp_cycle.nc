=== settings
D1 = 2
=== main
G0 X-20 F100
G41 X0 D1
G81 X10 Z-5 R2
M30
=== says
main.nc:3:1: error[nct-cycle-in-comp]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -20 0 0 t0.08
main.nc:3:1: error[nct-cycle-in-comp]: drilling cycles cannot run while cutter compensation (G41, G42) is on: program G40 first
    G81 X10 Z-5 R2
    ^~~~~~~~~~~~~~
alarm: 3 blocks, 1 motions, 1 errors, 0 warnings
