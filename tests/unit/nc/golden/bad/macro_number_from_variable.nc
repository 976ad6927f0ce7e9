=== main
#1=5
N#1 X1
M30
=== says
main.nc:2:1: error[nct-2064]
=== expect
file 0 main.nc
main.nc:2:1: error[nct-2064]: syntax error: a block number is a plain number
    N#1 X1
    ^~
    note: #1 = 5
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings
