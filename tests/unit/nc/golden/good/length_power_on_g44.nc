=== about
proves: nct-15.3-N1300
=== settings
N1300.G44 = 1
H1 = 10
=== main
G0 Z5 H1
M30
=== truth
0 0 -5
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 -5 t0.02
2: event end code="M30"
end of program: 2 blocks, 1 motions, 0 errors, 0 warnings
