=== about
G10.9 from radius to diameter: X50 is then read as X100; the axis does not move.
proves: nct-5.3.1-G10.9 nct-5.3-DIA
=== main
G1 X50 F100
#100=#5001
G10.9 X1 Y1
#101=#5001
G10.9 X0 Y0
Y#100 Z#101
M30
=== truth
50 0 0
50 50 100
=== expect
file 0 main.nc
1: feed from 0 0 0 to 50 0 0 F100 t30
6: feed to 50 50 100 F100 t67.082
7: event end code="M30"
end of program: 7 blocks, 2 motions, 0 errors, 0 warnings
