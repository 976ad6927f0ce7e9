=== about
An alarm with a number alone, behind a condition.
proves: nct-23.1.8-3000
=== main
G0 X1
IF[#1EQ#0] #_ALM=5
X2
M30
=== says
main.nc:2:1: error[nct-4005]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 0 t0.004
main.nc:2:1: error[nct-4005]: alarm of the program (01400500)
    IF[#1EQ#0] #_ALM=5
    ^~~~~~~~~~~~~~~~~~
    note: #1 is vacant
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings
