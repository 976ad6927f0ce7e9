=== about
proves: nct-23.6-errors
=== settings
D1 = 5
=== main
G0 X0 Y0 Z2
G65 P9999 X60 Y40 K2 R8 D1 E60 Q4 F400
M30
=== says
main.nc:2:1: error[nct-macro-error-1]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 2 t0.008
main.nc:2:1: error[nct-macro-error-1]: MACRO ERROR 1: the depth of the pocket is not given
    G65 P9999 X60 Y40 K2 R8 D1 E60 Q4 F400
    ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings
