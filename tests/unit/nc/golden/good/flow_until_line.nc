=== settings
until_line = 2
=== main
G0 X1
G0 X2
G0 X3
M30
=== truth
1 0 0
2 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
2: event end code="until"
until: 2 blocks, 2 motions, 0 errors, 0 warnings
