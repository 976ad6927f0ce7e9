=== about
M97 inside the macro ends it, from a subprogram of it too.
proves: nct-23.4-M97
=== settings
N1758.USD = 1
N1758.TPI = 1
interrupt = 10
=== main
M96 P50
N10 G0 X10
X1
M30
=== sub O0050
Z5
M98 P51
Z999
M99
=== sub O0051
M97
Z888
M99
=== truth
rapid 10 0 0
rapid 10 0 5
rapid 1 0 5
=== expect
file 0 main.nc
file 1 O0050
1: event function code="M96"
2 N10: rapid from 0 0 0 to 10 0 0 t0.04
1/1 depth 1: rapid to 10 0 5 t0.02
file 2 O0051
2/1 depth 2: event function code="M97"
3: rapid to 1 0 5 t0.036
4: event end code="M30"
end of program: 7 blocks, 3 motions, 0 errors, 0 warnings
