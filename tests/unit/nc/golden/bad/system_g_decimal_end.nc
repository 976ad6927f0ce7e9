=== about
proves: nct-23.3.4-Gdec
=== settings
N1717 = 310.5
N1718 = 4000
N1719 = 10
=== main
G311.5 A1
M30
=== says
main.nc:1:1: error[nct-2123]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2123]: function not implemented: G311.5 is not a code of this control
    G311.5 A1
    ^~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
