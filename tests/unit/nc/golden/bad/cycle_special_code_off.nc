=== about
proves: nct-18-CSM
=== main
G83.1 X5 Z-15 R2 Q6 F100
M30
=== says
main.nc:1:1: error[nct-cycle-coding]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-cycle-coding]: G83.1 is no drilling cycle with N1503.CSM = 0
    G83.1 X5 Z-15 R2 Q6 F100
    ^~~~~~~~~~~~~~~~~~~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
