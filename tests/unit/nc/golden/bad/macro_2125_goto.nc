=== about
proves: nct-23.2.8-GOTO
=== main
GOTO160
G0 X1
M30
=== says
error[nct-2125]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2125]: block N160 not found: main.nc
    GOTO160
    ^~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
