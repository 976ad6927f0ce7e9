=== about
proves: nct-16.1-G68
=== main
G17 G90 G0 X0 Y0
G68 X0 Y0
M30
=== says
main.nc:2:1: error[nct-2004]
=== expect
file 0 main.nc
main.nc:2:1: error[nct-2004]: missing data R: G68 needs an angle
    G68 X0 Y0
    ^~~~~~~~~
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings
