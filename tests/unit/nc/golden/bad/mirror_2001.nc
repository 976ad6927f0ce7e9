=== about
proves: nct-16.3-2001
=== main
G17 G90 G0 X0 Y0
G68 X0 Y0 R30
G51.1 X10
M30
=== says
error[nct-2001]
=== expect
file 0 main.nc
main.nc:3:1: error[nct-2001]: mirroring cannot be switched on or off in state G51 or G68
    G51.1 X10
    ^~~~~~~~~
alarm: 3 blocks, 0 motions, 1 errors, 0 warnings
