%
G0 X1 (a
b) Y2
M30
(of the first
setup)
(of the second
=== says
main.nc:7:1: error[nct-open-comment]
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 1 0 0 t0.004
3: rapid to 1 2 0 t0.008
main.nc:7:1: error[nct-open-comment]: the text ends inside a comment: ')' is missing
    (of the second
    ^
alarm: 3 blocks, 2 motions, 1 errors, 0 warnings
