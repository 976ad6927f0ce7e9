M123456789
M30
=== says
main.nc:1:1: error[nct-2002]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2002]: M data out of range: an integer from 0 to 99999999 is expected
    M123456789
    ^~~~~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
