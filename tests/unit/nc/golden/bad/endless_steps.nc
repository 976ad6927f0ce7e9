=== about
A loop that goes on step by step is never the same: the limit of blocks ends it.
Truth: G91 and then pairs of blocks: 1 + 6 + 5 = 12.
=== settings
block_limit = 12
=== main
G91
N1 G0 X1
GOTO 1
M30
=== truth
rapid 1 0 0
rapid 2 0 0
rapid 3 0 0
rapid 4 0 0
rapid 5 0 0
rapid 6 0 0
=== says
main.nc:3:1: error
block limit: 12 blocks, 6 motions, 1 errors
=== expect
file 0 main.nc
2 N1: rapid from 0 0 0 to 1 0 0 t0.004
2 N1: rapid to 2 0 0 t0.004
2 N1: rapid to 3 0 0 t0.004
2 N1: rapid to 4 0 0 t0.004
2 N1: rapid to 5 0 0 t0.004
2 N1: rapid to 6 0 0 t0.004
main.nc:3:1: error[nct-block-limit]: 12 blocks executed without an end, chords of curves included: an endless loop in lines 1 to 3? [simulation] max_blocks of the job sets the limit
    GOTO 1
    ^~~~~~
block limit: 12 blocks, 6 motions, 1 errors, 0 warnings
