=== about
A jump back with nothing changed: told before the limit of blocks.
=== settings
block_limit = 1000
=== main
N1 G0 X1
X2
M99 P1
=== says
error[nct-endless-loop]
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
main.nc:1:1: error[nct-endless-loop]: an endless loop: the program comes back to lines 1 to 3 with nothing changed
    N1 G0 X1
    ^~~~~~~~
block limit: 12 blocks, 8 motions, 1 errors, 0 warnings
