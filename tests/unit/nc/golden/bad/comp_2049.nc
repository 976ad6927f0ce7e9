=== about
proves: nct-15.5.7-AAL nct-15.5.7-2049
=== settings
D1 = 10
N1403.AAL = 1
=== main
G0 X-50 Y0 F100
G41 X-20 D1
G1 X40
G3 X45 Y5 R5
G1 Y45
G40 Y80
M30
=== says
error[nct-2049]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -50 0 0 t0.2
2: rapid to -20 10 0 t0.12
main.nc:4:1: error[nct-2049]: interference error: the compensated path runs against the programmed one
    G3 X45 Y5 R5
    ^~~~~~~~~~~~
alarm: 6 blocks, 2 motions, 1 errors, 0 warnings
