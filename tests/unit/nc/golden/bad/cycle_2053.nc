=== about
proves: nct-18-2053
=== main
G0 Z10
G81 X5 Z-5 F100
M30
=== says
error[nct-2053]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 10 t0.04
main.nc:2:1: error[nct-2053]: no bottom point or R point: the cycle needs both
    G81 X5 Z-5 F100
    ^~~~~~~~~~~~~~~
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings
