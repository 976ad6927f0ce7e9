=== about
The first ) closes a comment.
=== main
G0 X1
(outer (inner) rest)
M30
=== says
main.nc:2:16: error[nct-2064]: syntax error: comments do not nest
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 0 t0.004
main.nc:2:16: error[nct-2064]: syntax error: comments do not nest: a ( stands inside of one, and the first ) has closed it
    (outer (inner) rest)
                   ^~~~
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings
