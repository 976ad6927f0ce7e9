G43 H1000
M30
=== says
main.nc:1:5: error[nct-2002]
=== expect
file 0 main.nc
main.nc:1:5: error[nct-2002]: H data out of range: an integer from 0 to 999 is expected
    G43 H1000
        ^~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
