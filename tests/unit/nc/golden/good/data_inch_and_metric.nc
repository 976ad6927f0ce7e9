=== about
proves: nct-5.2-G20 nct-5.2-G21 nct-3-G54
=== main
G21 G0 G54 X20 Y10 Z50
G20 X2 Y3 Z1
G1 X1 F10
M30
=== truth
20 10 50
50.8 76.2 25.4
25.4 76.2 25.4
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 20 10 50 t0.2
2: rapid to 50.8 76.2 25.4 t0.2648
3: feed to 25.4 76.2 25.4 F254 t6
4: event end code="M30"
end of program: 4 blocks, 3 motions, 0 errors, 0 warnings
