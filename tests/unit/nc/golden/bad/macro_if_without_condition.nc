=== main
IF #1EQ2 GOTO1
M30
=== says
main.nc:1:4: error[nct-2064]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2064]: syntax error: a condition in brackets is expected
    IF #1EQ2 GOTO1
       ^
    note: #1 is vacant
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
