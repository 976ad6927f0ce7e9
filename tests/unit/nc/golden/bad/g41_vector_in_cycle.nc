=== settings
D1 = 5
=== main
G0 Z10
G81 X5 Z-5 R2 F100
G41 X10 I5
M30
=== says
main.nc:3:1: error[nct-cycle-in-comp]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 10 t0.04
2: rapid to 5 0 10 t0.02
2: rapid to 5 0 2 t0.032
2: feed to 5 0 -5 F100 t4.2
2: rapid to 5 0 10 t0.06
main.nc:3:1: error[nct-cycle-in-comp]: drilling cycles cannot run while cutter compensation (G41, G42) is on: program G40 first
    G41 X10 I5
    ^~~~~~~~~~
alarm: 3 blocks, 5 motions, 1 errors, 0 warnings
