=== settings
block_limit = 50
=== main
G91 G81 X1 Z-1 R-1 F100 L99999999
M30
=== says
main.nc:1:1: error[nct-block-limit]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 0 t0.004
1: rapid to 1 0 -1 t0.004
1: feed to 1 0 -2 F100 t0.6
1: rapid to 1 0 0 t0.008
1: rapid to 2 0 0 t0.004
1: rapid to 2 0 -1 t0.004
1: feed to 2 0 -2 F100 t0.6
1: rapid to 2 0 0 t0.008
1: rapid to 3 0 0 t0.004
1: rapid to 3 0 -1 t0.004
1: feed to 3 0 -2 F100 t0.6
1: rapid to 3 0 0 t0.008
1: rapid to 4 0 0 t0.004
1: rapid to 4 0 -1 t0.004
1: feed to 4 0 -2 F100 t0.6
1: rapid to 4 0 0 t0.008
1: rapid to 5 0 0 t0.004
1: rapid to 5 0 -1 t0.004
1: feed to 5 0 -2 F100 t0.6
1: rapid to 5 0 0 t0.008
1: rapid to 6 0 0 t0.004
1: rapid to 6 0 -1 t0.004
1: feed to 6 0 -2 F100 t0.6
1: rapid to 6 0 0 t0.008
1: rapid to 7 0 0 t0.004
1: rapid to 7 0 -1 t0.004
1: feed to 7 0 -2 F100 t0.6
1: rapid to 7 0 0 t0.008
1: rapid to 8 0 0 t0.004
1: rapid to 8 0 -1 t0.004
1: feed to 8 0 -2 F100 t0.6
1: rapid to 8 0 0 t0.008
1: rapid to 9 0 0 t0.004
1: rapid to 9 0 -1 t0.004
1: feed to 9 0 -2 F100 t0.6
1: rapid to 9 0 0 t0.008
1: rapid to 10 0 0 t0.004
1: rapid to 10 0 -1 t0.004
1: feed to 10 0 -2 F100 t0.6
1: rapid to 10 0 0 t0.008
1: rapid to 11 0 0 t0.004
1: rapid to 11 0 -1 t0.004
1: feed to 11 0 -2 F100 t0.6
1: rapid to 11 0 0 t0.008
1: rapid to 12 0 0 t0.004
1: rapid to 12 0 -1 t0.004
1: feed to 12 0 -2 F100 t0.6
1: rapid to 12 0 0 t0.008
1: rapid to 13 0 0 t0.004
1: rapid to 13 0 -1 t0.004
1: feed to 13 0 -2 F100 t0.6
1: rapid to 13 0 0 t0.008
1: rapid to 14 0 0 t0.004
1: rapid to 14 0 -1 t0.004
1: feed to 14 0 -2 F100 t0.6
1: rapid to 14 0 0 t0.008
1: rapid to 15 0 0 t0.004
1: rapid to 15 0 -1 t0.004
1: feed to 15 0 -2 F100 t0.6
1: rapid to 15 0 0 t0.008
1: rapid to 16 0 0 t0.004
1: rapid to 16 0 -1 t0.004
1: feed to 16 0 -2 F100 t0.6
1: rapid to 16 0 0 t0.008
1: rapid to 17 0 0 t0.004
1: rapid to 17 0 -1 t0.004
1: feed to 17 0 -2 F100 t0.6
1: rapid to 17 0 0 t0.008
1: rapid to 18 0 0 t0.004
1: rapid to 18 0 -1 t0.004
1: feed to 18 0 -2 F100 t0.6
1: rapid to 18 0 0 t0.008
1: rapid to 19 0 0 t0.004
1: rapid to 19 0 -1 t0.004
1: feed to 19 0 -2 F100 t0.6
1: rapid to 19 0 0 t0.008
1: rapid to 20 0 0 t0.004
1: rapid to 20 0 -1 t0.004
1: feed to 20 0 -2 F100 t0.6
1: rapid to 20 0 0 t0.008
1: rapid to 21 0 0 t0.004
1: rapid to 21 0 -1 t0.004
1: feed to 21 0 -2 F100 t0.6
1: rapid to 21 0 0 t0.008
1: rapid to 22 0 0 t0.004
1: rapid to 22 0 -1 t0.004
1: feed to 22 0 -2 F100 t0.6
1: rapid to 22 0 0 t0.008
1: rapid to 23 0 0 t0.004
1: rapid to 23 0 -1 t0.004
1: feed to 23 0 -2 F100 t0.6
1: rapid to 23 0 0 t0.008
1: rapid to 24 0 0 t0.004
1: rapid to 24 0 -1 t0.004
1: feed to 24 0 -2 F100 t0.6
1: rapid to 24 0 0 t0.008
1: rapid to 25 0 0 t0.004
1: rapid to 25 0 -1 t0.004
1: feed to 25 0 -2 F100 t0.6
1: rapid to 25 0 0 t0.008
1: rapid to 26 0 0 t0.004
1: rapid to 26 0 -1 t0.004
1: feed to 26 0 -2 F100 t0.6
1: rapid to 26 0 0 t0.008
1: rapid to 27 0 0 t0.004
1: rapid to 27 0 -1 t0.004
1: feed to 27 0 -2 F100 t0.6
1: rapid to 27 0 0 t0.008
1: rapid to 28 0 0 t0.004
1: rapid to 28 0 -1 t0.004
1: feed to 28 0 -2 F100 t0.6
1: rapid to 28 0 0 t0.008
1: rapid to 29 0 0 t0.004
1: rapid to 29 0 -1 t0.004
1: feed to 29 0 -2 F100 t0.6
1: rapid to 29 0 0 t0.008
1: rapid to 30 0 0 t0.004
1: rapid to 30 0 -1 t0.004
1: feed to 30 0 -2 F100 t0.6
1: rapid to 30 0 0 t0.008
1: rapid to 31 0 0 t0.004
1: rapid to 31 0 -1 t0.004
1: feed to 31 0 -2 F100 t0.6
1: rapid to 31 0 0 t0.008
1: rapid to 32 0 0 t0.004
1: rapid to 32 0 -1 t0.004
1: feed to 32 0 -2 F100 t0.6
1: rapid to 32 0 0 t0.008
1: rapid to 33 0 0 t0.004
1: rapid to 33 0 -1 t0.004
1: feed to 33 0 -2 F100 t0.6
1: rapid to 33 0 0 t0.008
1: rapid to 34 0 0 t0.004
1: rapid to 34 0 -1 t0.004
1: feed to 34 0 -2 F100 t0.6
1: rapid to 34 0 0 t0.008
1: rapid to 35 0 0 t0.004
1: rapid to 35 0 -1 t0.004
1: feed to 35 0 -2 F100 t0.6
1: rapid to 35 0 0 t0.008
1: rapid to 36 0 0 t0.004
1: rapid to 36 0 -1 t0.004
1: feed to 36 0 -2 F100 t0.6
1: rapid to 36 0 0 t0.008
1: rapid to 37 0 0 t0.004
1: rapid to 37 0 -1 t0.004
1: feed to 37 0 -2 F100 t0.6
1: rapid to 37 0 0 t0.008
1: rapid to 38 0 0 t0.004
1: rapid to 38 0 -1 t0.004
1: feed to 38 0 -2 F100 t0.6
1: rapid to 38 0 0 t0.008
1: rapid to 39 0 0 t0.004
1: rapid to 39 0 -1 t0.004
1: feed to 39 0 -2 F100 t0.6
1: rapid to 39 0 0 t0.008
1: rapid to 40 0 0 t0.004
1: rapid to 40 0 -1 t0.004
1: feed to 40 0 -2 F100 t0.6
1: rapid to 40 0 0 t0.008
1: rapid to 41 0 0 t0.004
1: rapid to 41 0 -1 t0.004
1: feed to 41 0 -2 F100 t0.6
1: rapid to 41 0 0 t0.008
1: rapid to 42 0 0 t0.004
1: rapid to 42 0 -1 t0.004
1: feed to 42 0 -2 F100 t0.6
1: rapid to 42 0 0 t0.008
1: rapid to 43 0 0 t0.004
1: rapid to 43 0 -1 t0.004
1: feed to 43 0 -2 F100 t0.6
1: rapid to 43 0 0 t0.008
1: rapid to 44 0 0 t0.004
1: rapid to 44 0 -1 t0.004
1: feed to 44 0 -2 F100 t0.6
1: rapid to 44 0 0 t0.008
1: rapid to 45 0 0 t0.004
1: rapid to 45 0 -1 t0.004
1: feed to 45 0 -2 F100 t0.6
1: rapid to 45 0 0 t0.008
1: rapid to 46 0 0 t0.004
1: rapid to 46 0 -1 t0.004
1: feed to 46 0 -2 F100 t0.6
1: rapid to 46 0 0 t0.008
1: rapid to 47 0 0 t0.004
1: rapid to 47 0 -1 t0.004
1: feed to 47 0 -2 F100 t0.6
1: rapid to 47 0 0 t0.008
1: rapid to 48 0 0 t0.004
1: rapid to 48 0 -1 t0.004
1: feed to 48 0 -2 F100 t0.6
1: rapid to 48 0 0 t0.008
1: rapid to 49 0 0 t0.004
1: rapid to 49 0 -1 t0.004
1: feed to 49 0 -2 F100 t0.6
1: rapid to 49 0 0 t0.008
1: rapid to 50 0 0 t0.004
1: rapid to 50 0 -1 t0.004
1: feed to 50 0 -2 F100 t0.6
1: rapid to 50 0 0 t0.008
main.nc:1:1: error[nct-block-limit]: 50 blocks executed without an end, chords of curves included: an endless loop in line 1? [simulation] max_blocks of the job sets the limit
    G91 G81 X1 Z-1 R-1 F100 L99999999
    ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
block limit: 1 blocks, 200 motions, 1 errors, 0 warnings
