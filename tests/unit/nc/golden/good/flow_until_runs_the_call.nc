=== settings
until_block = 20
=== main
N10 G0 X1
N20 M98 P11
N30 G0 X3
M30
=== sub O0011.nc
G0 X2
M99
=== truth
1 0 0
2 0 0
=== expect
file 0 main.nc
1 N10: rapid from 0 0 0 to 1 0 0 t0.004
file 1 O0011.nc
1/1 depth 1: rapid to 2 0 0 t0.004
2: event end code="until"
until: 4 blocks, 2 motions, 0 errors, 0 warnings
