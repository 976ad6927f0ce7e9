G17 G90 G0 X50 Y0 F500
G3 X-20 I-50
M30
=== says
error[nct-2012]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 50 0 0 t0.2
main.nc:2:1: error[nct-2012]: circle radius difference error: 30 mm between start and end radius, 2 allowed
    G3 X-20 I-50
    ^~~~~~~~~~~~
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings
