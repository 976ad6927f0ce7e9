=== main
GOTO#1
M30
=== says
main.nc:1:1: error[nct-2125]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2125]: block not found: the number of GOTO is vacant
    GOTO#1
    ^~~~~~
    note: #1 is vacant
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
