=== main
G0 X10 GOTO5
M30
=== says
main.nc:1:8: error[nct-2064]
=== expect
file 0 main.nc
main.nc:1:8: error[nct-2064]: syntax error: GOTO cannot stand behind other words
    G0 X10 GOTO5
           ^~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
