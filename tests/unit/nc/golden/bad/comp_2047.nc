=== about
proves: nct-15.5.2-2047
=== settings
D1 = 10
N1403.IEN = 0
=== main
G0 X-50 Y0 F100
G41 X-20 D1
G1 X0
G3 X-8 Y8 R8
G1 X-50
G40 Y50
M30
=== says
error[nct-2047]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -50 0 0 t0.2
2: rapid to -20 10 0 t0.12
main.nc:4:1: error[nct-2047]: no intersection point G41, G42: the tool does not fit into the inner corner
    G3 X-8 Y8 R8
    ^~~~~~~~~~~~
alarm: 5 blocks, 2 motions, 1 errors, 0 warnings
