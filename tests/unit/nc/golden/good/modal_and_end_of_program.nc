=== about
The macro runs before the program ends.
proves: nct-23.3.2-G66
=== main
G66 P2
G0 X5 M30
X100
=== sub O0002
Y7
M99
=== truth
rapid 5 0 0
rapid 5 7 0
=== expect
file 0 main.nc
file 1 O0002
2: rapid from 0 0 0 to 5 0 0 t0.02
1/1 depth 1: rapid to 5 7 0 t0.028
2: event end code="M30"
end of program: 4 blocks, 2 motions, 0 errors, 0 warnings
