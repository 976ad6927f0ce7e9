=== about
A bit for each mirrored axis: X and Z are axes 1 and 3.
proves: nct-23.1.12-3007
=== main
G51.1 X0 Z0
G0 Y#3007
G50.1 X0
Y#_MIRIMG
G50.1
Y#3007
M30
=== truth
0 5 0
0 4 0
0 0 0
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 0 5 0 t0.02
4: rapid to 0 4 0 t0.004
6: rapid to 0 0 0 t0.016
7: event end code="M30"
end of program: 7 blocks, 3 motions, 0 errors, 0 warnings
