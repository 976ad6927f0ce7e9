=== about
proves: nct-15.5.6-G39
=== settings
D1 = 5
=== main
G0 X-50
G41 G1 X0 D1 F100
X50
G39
Y50
G40 X0
M30
=== says
main.nc:4:1: error[nct-cutter-comp]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -50 0 0 t0.2
2: feed to 0 5 0 F100 t30.1496
3: feed to 50 5 0 F100 t30
main.nc:4:1: error[nct-cutter-comp]: G39 on an inner corner
    G39
    ^~~
alarm: 6 blocks, 3 motions, 1 errors, 0 warnings
