=== main
#1=##120
M30
=== says
main.nc:1:4: error[nct-2064]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2064]: syntax error: '#' is followed by a number, a name or '['
    #1=##120
       ^
    note: #1 is vacant
    note: #120 is vacant
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
