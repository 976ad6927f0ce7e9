=== main
#1=5 X3
M30
=== says
main.nc:1:6: error[nct-2064]
=== expect
file 0 main.nc
main.nc:1:6: error[nct-2064]: syntax error: nothing may follow the statement
    #1=5 X3
         ^~
    note: #1 = 5
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
