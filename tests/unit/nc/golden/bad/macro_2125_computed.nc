=== main
#1=33
GOTO[#1*2]
M30
=== says
error[nct-2125]
=== expect
file 0 main.nc
main.nc:2:1: error[nct-2125]: block N66 not found: main.nc
    GOTO[#1*2]
    ^~~~~~~~~~
    note: #1 = 33
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings
