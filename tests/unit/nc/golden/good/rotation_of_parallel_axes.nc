=== about
G68 in a plane of parallel axes turns these, and mixed planes.
proves: nct-16.1-G68
=== settings
axis = U 4 linear parallel X
axis = V 5 linear parallel Y
=== main
G17 G0 U0 V0
G68 U0 V0 R90
G1 U10 V0 F100
G69
G0 U0 V0
G17 X0 V0
G68 X10 V0 R90
G1 X15 V0 Y3
G69
M30
=== truth
0 10 0
0 0 0
10 8 0
=== expect
file 0 main.nc
3: feed from 0 0 0 to 0 10 0 F100 t6
5: rapid to 0 0 0 t0.04
8: feed to 10 8 0 F100 t6.9455
10: event end code="M30"
end of program: 10 blocks, 3 motions, 0 errors, 0 warnings
