G10 L10 P1000 R5
M30
=== says
main.nc:1:9: error[nct-2002]
=== expect
file 0 main.nc
main.nc:1:9: error[nct-2002]: P data out of range: an integer from 1 to 999 is expected
    G10 L10 P1000 R5
            ^~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
