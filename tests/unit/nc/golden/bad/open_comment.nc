G0 X1
(this file is cut of
=== says
main.nc:2:1: error[nct-open-comment]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 0 t0.004
main.nc:2:1: error[nct-open-comment]: the text ends inside a comment: ')' is missing
    (this file is cut of
    ^
alarm: 1 blocks, 1 motions, 1 errors, 0 warnings
