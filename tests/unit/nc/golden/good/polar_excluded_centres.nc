=== about
Centres of rotation and scaling and the points of mirroring stay rectangular in G16.
proves: nct-5.4-excl
=== main
G0 G16 X10 Y90
G68 X20 Y30 R90
X10 Y0
G69
G51 X2 Y4 P2
X10 Y0
G50
G51.1 X5
X10 Y0
G50.1 X0
M30
=== truth
0 10 0
50 20 0
18 -4 0
0 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 10 0 t0.04
3: rapid to 50 20 0 t0.2
6: rapid to 18 -4 0 t0.128
9: rapid to 0 0 0 t0.072
11: event end code="M30"
end of program: 11 blocks, 4 motions, 0 errors, 0 warnings
