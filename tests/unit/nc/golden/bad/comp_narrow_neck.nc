=== about
The same with six more blocks: alarm 2049 before the line in front of the neck.
proves: nct-15.5.7-N1404 nct-15.5.7-2049
=== settings
D1 = 5
N1404 = 6
=== main
G0 X-100
G41 G1 X-50 D1 F1000
X0
X40
Y-10
X20
Y-40
X68
Y-10
X48
Y0
X90
X120
G40 X150
M30
=== says
error[nct-2049]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: feed to -50 5 0 F1000 t3.015
3: feed to 0 5 0 F1000 t3
main.nc:11:1: error[nct-2049]: interference error: the compensated path runs against the programmed one
    Y0
    ^~
alarm: 13 blocks, 3 motions, 1 errors, 0 warnings
