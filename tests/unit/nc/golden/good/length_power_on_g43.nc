=== about
proves: nct-15.3-N1300
=== settings
N1300.G43 = 1
H1 = 10
=== main
G0 Z5 H1
G49 Z5
M30
=== truth
0 0 15
0 0 5
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 15 t0.06
2: rapid to 0 0 5 t0.04
3: event end code="M30"
end of program: 3 blocks, 2 motions, 0 errors, 0 warnings
