=== about
proves: nct-17.3.2-LA
=== main
G17 G42 G0 X100 Y20 D0 F100
G1 X-30 Y-20
G3 X20 Y41 I20 J-10 R50 Q-1
G40 G0 Y60
M30
=== says
main.nc:3:1: error[nct-2012]
=== expect
file 0 main.nc
main.nc:3:1: error[nct-2012]: circle radius difference error: the end is not on the circle of I, J, K and R
    G3 X20 Y41 I20 J-10 R50 Q-1
    ^~~~~~~~~~~~~~~~~~~~~~~~~~~
alarm: 4 blocks, 0 motions, 1 errors, 0 warnings
