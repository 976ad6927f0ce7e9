=== about
proves: nct-23.3.4-Gblock
=== settings
N1714 = 2000
N1715 = 3400
N1716 = 50
=== main
G2050 A1
M30
=== says
error[nct-2123]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2123]: function not implemented: G2050 is not a code of this control
    G2050 A1
    ^~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
