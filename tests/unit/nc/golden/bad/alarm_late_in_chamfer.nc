=== about
A chamfer that the next block cannot have, found out of when the subprogram has returned.
Truth: alarm 2085 in the block of the chamfer, nothing moves.
=== main
F100
M98 P11
G0 X20
M30
=== sub O0011
G1 X10 ,C2
M99
=== says
O0011:1:1: error[nct-2085]
called from main.nc:2 by M98
0 motions, 1 errors
=== expect
file 0 main.nc
file 1 O0011
O0011:1:1: error[nct-2085]: illegal chamfer or rounding: no G1, G2 or G3 block in the plane follows
    G1 X10 ,C2
    ^~~~~~~~~~
    note: called from main.nc:2 by M98
alarm: 5 blocks, 0 motions, 1 errors, 0 warnings
