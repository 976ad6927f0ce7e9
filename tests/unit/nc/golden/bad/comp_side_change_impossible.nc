=== about
Half a circle of radius 30 with 5 mm inside, then 20 mm on the other side of a line: start and end are 75 mm apart, no arc of radius 30 joins
them.
proves: nct-15.5.4-err
=== settings
D1 = 5
D2 = 20
=== main
G0 X40 Y-60
G42 G1 X20 D1 F1000
X0
G2 X0 Y0 J30
G41 D2 G1 X50
X90
G40 X120
M30
=== says
main.nc:4:1: error[nct-cutter-comp]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 40 -60 0 t0.24
2: feed to 20 -55 0 F1000 t1.2369
3: feed to 0 -55 0 F1000 t1.2
main.nc:4:1: error[nct-cutter-comp]: the change of side G41, G42 has no solution here
    G2 X0 Y0 J30
    ^~~~~~~~~~~~
alarm: 7 blocks, 3 motions, 1 errors, 0 warnings
