=== about
L repeats at each motion, with the arguments of the G66 block; the subprogram of the block runs behind the macro.
proves: nct-23.3.2-G66
=== main
G91
G66 P2 L2 A3
G0 X1 M98 P11
X10
G67
G90
M30
=== sub O0002
Y#1
#1=99
M99
=== sub O0011
Z5
M99
=== truth
rapid 1 0 0
rapid 1 3 0
rapid 1 6 0
rapid 1 6 5
rapid 1 9 5
rapid 1 12 5
rapid 11 12 5
rapid 11 15 5
rapid 11 18 5
=== expect
file 0 main.nc
file 1 O0002
3: rapid from 0 0 0 to 1 0 0 t0.004
file 2 O0011
1/1 depth 1: rapid to 1 3 0 t0.012
1/1 depth 1: rapid to 1 6 0 t0.012
2/1 depth 1: rapid to 1 6 5 t0.02
1/1 depth 2: rapid to 1 9 5 t0.012
1/1 depth 2: rapid to 1 12 5 t0.012
4: rapid to 11 12 5 t0.04
1/1 depth 1: rapid to 11 15 5 t0.012
1/1 depth 1: rapid to 11 18 5 t0.012
7: event end code="M30"
end of program: 27 blocks, 9 motions, 0 errors, 0 warnings
