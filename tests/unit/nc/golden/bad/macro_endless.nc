=== settings
block_limit = 50
=== main
DO1
END1
M30
=== says
main.nc:1:1: error[nct-block-limit]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-block-limit]: 50 blocks executed without an end, chords of curves included: an endless loop in lines 1 to 2? [simulation] max_blocks of the job sets the limit
    DO1
    ^~~
block limit: 50 blocks, 0 motions, 1 errors, 0 warnings
