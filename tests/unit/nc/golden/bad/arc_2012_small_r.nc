G17 G0 G90 X0 Y0 F100
G2 X40 Y30 R10
M30
=== says
error[nct-2012]
=== expect
file 0 main.nc
main.nc:2:1: error[nct-2012]: circle radius difference error: 30 mm between start and end radius, 2 allowed
    G2 X40 Y30 R10
    ^~~~~~~~~~~~~~
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings
