=== about
An endless loop of jumps ends at the block limit.
Truth: G54 and then pairs of blocks: 1 + 25 + 24 = 50 with 25 steps of 1 mm, 0.6 s each.
proves: wl4-9.4.1-jmp
=== settings
control = wl4-mill
block_limit = 50
=== main
%E
G54
N010 G91 G1 X1 F100
N20 N10
M30
%
=== truth
feed 1 0 0 F 100 t 0.6
feed 2 0 0 F 100 t 0.6
feed 3 0 0 F 100 t 0.6
feed 4 0 0 F 100 t 0.6
feed 5 0 0 F 100 t 0.6
feed 6 0 0 F 100 t 0.6
feed 7 0 0 F 100 t 0.6
feed 8 0 0 F 100 t 0.6
feed 9 0 0 F 100 t 0.6
feed 10 0 0 F 100 t 0.6
feed 11 0 0 F 100 t 0.6
feed 12 0 0 F 100 t 0.6
feed 13 0 0 F 100 t 0.6
feed 14 0 0 F 100 t 0.6
feed 15 0 0 F 100 t 0.6
feed 16 0 0 F 100 t 0.6
feed 17 0 0 F 100 t 0.6
feed 18 0 0 F 100 t 0.6
feed 19 0 0 F 100 t 0.6
feed 20 0 0 F 100 t 0.6
feed 21 0 0 F 100 t 0.6
feed 22 0 0 F 100 t 0.6
feed 23 0 0 F 100 t 0.6
feed 24 0 0 F 100 t 0.6
feed 25 0 0 F 100 t 0.6
length 25
=== says
main.nc:4:1: error
block limit: 50 blocks, 25 motions, 1 errors
=== expect
file 0 main.nc
3 N10: feed from 0 0 0 to 1 0 0 F100 t0.6
3 N10: feed to 2 0 0 F100 t0.6
3 N10: feed to 3 0 0 F100 t0.6
3 N10: feed to 4 0 0 F100 t0.6
3 N10: feed to 5 0 0 F100 t0.6
3 N10: feed to 6 0 0 F100 t0.6
3 N10: feed to 7 0 0 F100 t0.6
3 N10: feed to 8 0 0 F100 t0.6
3 N10: feed to 9 0 0 F100 t0.6
3 N10: feed to 10 0 0 F100 t0.6
3 N10: feed to 11 0 0 F100 t0.6
3 N10: feed to 12 0 0 F100 t0.6
3 N10: feed to 13 0 0 F100 t0.6
3 N10: feed to 14 0 0 F100 t0.6
3 N10: feed to 15 0 0 F100 t0.6
3 N10: feed to 16 0 0 F100 t0.6
3 N10: feed to 17 0 0 F100 t0.6
3 N10: feed to 18 0 0 F100 t0.6
3 N10: feed to 19 0 0 F100 t0.6
3 N10: feed to 20 0 0 F100 t0.6
3 N10: feed to 21 0 0 F100 t0.6
3 N10: feed to 22 0 0 F100 t0.6
3 N10: feed to 23 0 0 F100 t0.6
3 N10: feed to 24 0 0 F100 t0.6
3 N10: feed to 25 0 0 F100 t0.6
main.nc:4:1: error[wl4-block-limit]: 50 blocks executed without an end: an endless loop in lines 2 to 4? [simulation] max_blocks of the job sets the limit
    N20 N10
    ^~~~~~~
block limit: 50 blocks, 25 motions, 1 errors, 0 warnings
