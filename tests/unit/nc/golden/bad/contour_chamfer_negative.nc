=== about
proves: nct-17.1-C
=== main
G1 X30 ,C-5 F100
M30
=== says
main.nc:1:8: error[nct-2002]
=== expect
file 0 main.nc
main.nc:1:8: error[nct-2002]: ,C data out of range: a length from 0
    G1 X30 ,C-5 F100
           ^~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
