=== about
Factors apart: the radius of an arc goes by the first axis of the plane (Z in G18), a chamfer by their mean. A factor left out is 1.
proves: nct-16.2-G51-IJK
=== main
G17 G51 X0 Y0 I2 J3
G1 X10 ,C3 F100
Y10
G50
G0 X0 Y0
G51 X0 Y0 I2
X1 Y1
G50
X0 Y0
G18 G51 X0 Z0 I2 K3
G1 Z10
G2 X10 Z20 R10
G50
M30
=== truth
12.5 0 0
20 7.5 0
20 30 0
0 0 0
2 1 0
0 0 0
0 0 30
20 0 60 center -9.9519 0 58.3013
=== expect
file 0 main.nc
2: feed from 0 0 0 to 12.5 0 0 F100 t7.5
2: feed to 20 7.5 0 F100 t6.364
3: feed to 20 30 0 F100 t13.5
5: rapid to 0 0 0 t0.12
7: rapid to 2 1 0 t0.008
9: rapid to 0 0 0 t0.008
11: feed to 0 0 30 F100 t18
12: feed arc to 20 0 60 center -9.9519 0 58.3012 normal 0 1 0 sweep -73.8724 F100 t23.2077
14: event end code="M30"
end of program: 14 blocks, 8 motions, 0 errors, 0 warnings
