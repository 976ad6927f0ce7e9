=== about
G68 again replaces the angle; G50.1 without an axis ends all mirrors.
proves: nct-16.1-G68 nct-16.3-G50.1
=== main
G0 X10
G68 X0 Y0 R30
G68 X0 Y0 R60
X10 Y0
G69
G0 X0 Y0
G51.1 X5 Y5
X1 Y1
G50.1
X2 Y2
M30
=== truth
10 0 0
5 8.6603 0
0 0 0
9 9 0
2 2 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 10 0 0 t0.04
4: rapid to 5 8.6603 0 t0.0346
6: rapid to 0 0 0 t0.0346
8: rapid to 9 9 0 t0.036
10: rapid to 2 2 0 t0.028
11: event end code="M30"
end of program: 11 blocks, 5 motions, 0 errors, 0 warnings
