G54.1 P100 X0
M30
=== says
main.nc:1:7: error[nct-2002]
=== expect
file 0 main.nc
main.nc:1:7: error[nct-2002]: P data out of range: an integer from 1 to 99 is expected
    G54.1 P100 X0
          ^~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
