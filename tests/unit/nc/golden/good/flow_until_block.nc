=== settings
until_block = 20
=== main
N10 G0 X1
N20 G0 X2
N30 G0 X3
M30
=== truth
1 0 0
2 0 0
=== expect
file 0 main.nc
1 N10: rapid from 0 0 0 to 1 0 0 t0.004
2 N20: rapid to 2 0 0 t0.004
2 N20: event end code="until"
until: 2 blocks, 2 motions, 0 errors, 0 warnings
