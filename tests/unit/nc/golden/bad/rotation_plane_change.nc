=== about
proves: nct-16.1-G68
=== main
G68 X0 Y0 R10
G18
M30
=== says
main.nc:2:1: error[nct-plane-in-rotation]
=== expect
file 0 main.nc
main.nc:2:1: error[nct-plane-in-rotation]: the plane cannot change while a rotation (G68) is on
    G18
    ^~~
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings
