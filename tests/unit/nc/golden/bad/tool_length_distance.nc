=== about
The rapid distance must be above the alarm distance.
Truth: 21.3; N3004 = 3 is below N3005 = 5; Z100 with H 10.
proves: nct-21.3-G37
=== settings
H5 = 10
N3004 = 3
=== main
F100
G43 G0 Z100 H5
G37 Z50
M30
=== truth
rapid 0 0 110
=== says
main.nc:3:1: error[nct-parameter]: G37: N3004 must be above N3005
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 0 0 110 t0.44
main.nc:3:1: error[nct-parameter]: G37: N3004 must be above N3005, and N3005 above 0
    G37 Z50
    ^~~~~~~
alarm: 3 blocks, 1 motions, 1 errors, 0 warnings
