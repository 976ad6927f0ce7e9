=== main
WHILE[#1=0] DO1
END1
M30
=== says
error[nct-2121]
=== expect
file 0 main.nc
main.nc:1:9: error[nct-2121]: wrong terminator: = (EQ compares)
    WHILE[#1=0] DO1
            ^
    note: #1 is vacant
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
