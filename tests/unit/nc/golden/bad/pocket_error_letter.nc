=== settings
D1 = 5
=== main
G0 X0 Y0 Z2
G65 P9999 X60 Y40 Z10 K2 D1 E60 Q4 F400 H3
M30
=== says
main.nc:2:1: error[nct-2017]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 2 t0.008
main.nc:2:1: error[nct-2017]: illegal address H: the pocket macro has no such argument
    G65 P9999 X60 Y40 Z10 K2 D1 E60 Q4 F400 H3
    ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings
