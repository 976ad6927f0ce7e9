=== about
Words that stay rectangular in G16: G52, G92, G53, G10 and the intermediate point of G28.
proves: nct-5.4-excl
=== settings
reference1 = 0 0 100
=== main
G0 G16 X10 Y90
G53 X20 Y30
G52 X5 Y6
X10 Y0
G52 X0 Y0
G92 X7 Y8
X0 Y0
G92 X0 Y0
G10 L2 P1 X1 Y2
X0 Y0
G28 X3 Y4
M30
=== truth
rapid 0 10 0
rapid 20 30 0
rapid 15 6 0
rapid 8 -2 0
rapid 9 0 0
rapid 12 4 0
rapid 0 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 10 0 t0.04
2: rapid to 20 30 0 t0.08
4: rapid to 15 6 0 t0.096
7: rapid to 8 -2 0 t0.032
10: rapid to 9 0 0 t0.008
11: rapid to 12 4 0 t0.016
11: rapid to 0 0 0 t0.048
12: event end code="M30"
end of program: 12 blocks, 7 motions, 0 errors, 0 warnings
