=== settings
block_limit = 1000
=== main
N1 G0 X1
X2
M99 P1
=== says
main.nc:2:1: error[nct-block-limit]
=== expect
file 0 main.nc
1 N1: rapid from 0 0 0 to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
2: rapid to 2 0 0 t0.004
1 N1: rapid to 1 0 0 t0.004
main.nc:2:1: error[nct-block-limit]: 1000 blocks executed without an end, chords of curves included: an endless loop in lines 1 to 3? [simulation] max_blocks of the job sets the limit
    X2
    ^~
block limit: 1000 blocks, 667 motions, 1 errors, 0 warnings
