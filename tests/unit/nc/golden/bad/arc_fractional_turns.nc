G0 X10 F100
G3 I-10 L1.5
M30
=== says
main.nc:2:9: error[nct-2002]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 10 0 0 t0.04
main.nc:2:9: error[nct-2002]: L data out of range: an integer from 1 to 99999999 is expected
    G3 I-10 L1.5
            ^~~~
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings
