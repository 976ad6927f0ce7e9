=== about
One relation in a condition, no more.
proves: nct-23.2.9-IF-GOTO
=== main
IF[[1EQ1]AND[2EQ2]] GOTO5
N5 M30
=== says
error[nct-2064]
=== expect
file 0 main.nc
main.nc:1:6: error[nct-2064]: syntax error: an operator or ']' is expected
    IF[[1EQ1]AND[2EQ2]] GOTO5
         ^
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
