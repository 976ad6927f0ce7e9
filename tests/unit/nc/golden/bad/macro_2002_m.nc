=== main
#112=1234567890
M#112
M30
=== says
error[nct-2002]
=== expect
file 0 main.nc
main.nc:2:1: error[nct-2002]: M data out of range
    M#112
    ^~~~~
    note: #112 = 1234567890
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings
