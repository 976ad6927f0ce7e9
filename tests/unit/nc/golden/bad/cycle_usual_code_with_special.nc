=== about
proves: nct-18-CSM
=== settings
N1503.CSM = 1
=== main
G73 X5 Z-15 R2 Q6 F100
M30
=== says
main.nc:1:1: error[nct-cycle-coding]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-cycle-coding]: G73 is no drilling cycle with N1503.CSM = 1
    G73 X5 Z-15 R2 Q6 F100
    ^~~~~~~~~~~~~~~~~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
