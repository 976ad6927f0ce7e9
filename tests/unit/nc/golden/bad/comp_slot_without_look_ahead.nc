=== about
A slot of 8 mm and a cutter of radius 5 without more look-ahead: alarm 2049.
proves: nct-15.5.7-2049
=== settings
D1 = 5
=== main
G0 X-100
G41 G1 X-50 D1 F1000
X40
Y-30
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
3: feed to 45 5 0 F1000 t5.7
main.nc:5:1: error[nct-2049]: interference error: the compensated path runs against the programmed one
    X48
    ^~~
alarm: 7 blocks, 3 motions, 1 errors, 0 warnings
