=== about
proves: nct-16.2-G51-P
=== main
G51 X0 Y0
M30
=== says
main.nc:1:1: error[nct-2004]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2004]: missing data P: G51 needs a factor: P, or I, J, K
    G51 X0 Y0
    ^~~~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
