=== about
A step of 3 mm between two parallel lines, cutter of radius 10: they do not meet, alarm 2049.
proves: nct-15.5.7-2049
=== settings
D1 = 10
=== main
G0 X-100
G41 G1 X-50 D1 F1000
X40
Y3
X0
X-50
G40 X-90
M30
=== says
error[nct-2049]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: feed to -50 10 0 F1000 t3.0594
main.nc:4:1: error[nct-2049]: interference error: the compensated path runs against the programmed one
    Y3
    ^~
alarm: 6 blocks, 2 motions, 1 errors, 0 warnings
