=== about
proves: nct-18-2053 nct-18-axis
=== settings
axis = W 4 linear parallel Z
=== main
G81 X0 Y0 Z-5 R2 F100
X10 W-5
M30
=== says
error[nct-2053]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 2 t0.008
1: feed to 0 0 -5 F100 t4.2
1: rapid to 0 0 0 t0.02
main.nc:2:1: error[nct-2053]: no bottom point or R point: a new drill axis needs R
    X10 W-5
    ^~~~~~~
alarm: 2 blocks, 3 motions, 1 errors, 0 warnings
