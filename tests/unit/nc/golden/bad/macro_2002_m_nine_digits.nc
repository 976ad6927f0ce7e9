=== about
A value beyond the digits of its address.
proves: nct-23.1.1-ref
=== main
#112=123456789
M#112
M30
=== says
error[nct-2002]
=== expect
file 0 main.nc
main.nc:2:1: error[nct-2002]: M data out of range: an integer from 0 to 99999999 is expected
    M#112
    ^~~~~
    note: M#112 = 123456789
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings
