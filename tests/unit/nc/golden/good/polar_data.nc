=== about
Polar data: radius and angle of the plane's axes, absolute from the origin, incremental from the block's start.
The manual's four blocks; inch radius, G18 with Z as radius and X as angle, words outside the plane.
proves: nct-5.4-G16 nct-5.4-G15
=== main
G0 X0 Y0 Z5
G90 G16 X100 Y60
G90 G16 X100 YI40
G15 X0 Y0
G90 G16 X100 Y60
G91 X50 Y40
G15 G90 X0 Y0
G16 X100 Y60
XI50 Y60
G15 X0 Y0
G20 G16 X1 Y90 Z1
G15 G21 X0 Y0 Z0
G18 G16 Z10 X30 Y3
M30
=== truth
rapid 0 0 5
rapid 50 86.6025 5
rapid -17.3648 98.4808 5
rapid 0 0 5
rapid 50 86.6025 5
rapid 41.3176 135.8429 5
rapid 0 0 5
rapid 50 86.6025 5
rapid 75 129.9038 5
rapid 0 0 5
rapid 0 25.4 25.4
rapid 0 0 0
rapid 5 3 8.6603
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 5 t0.02
2: rapid to 50 86.6025 5 t0.3464
3: rapid to -17.3648 98.4808 5 t0.2695
4: rapid to 0 0 5 t0.3939
5: rapid to 50 86.6025 5 t0.3464
6: rapid to 41.3176 135.8429 5 t0.197
7: rapid to 0 0 5 t0.5434
8: rapid to 50 86.6025 5 t0.3464
9: rapid to 75 129.9038 5 t0.1732
10: rapid to 0 0 5 t0.5196
11: rapid to 0 25.4 25.4 t0.1016
12: rapid to 0 0 0 t0.1016
13: rapid to 5 3 8.6603 t0.0346
14: event end code="M30"
end of program: 14 blocks, 13 motions, 0 errors, 0 warnings
