=== main
WHILE[#1GT0]
X1
M30
=== says
error[nct-2110]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2110]: WHILE without DO
    WHILE[#1GT0]
    ^~~~~~~~~~~~
    note: #1 is vacant
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
