=== about
X programmed in diameter: coordinates, increments, shifts and zero points are halved; I, J, K and R and
the feed are not. A hole at X in diameter.
proves: nct-5.3-DIA nct-5.3-N0106-0
=== settings
N0106.DIA.1 = 1
=== main
G0 X40 Y0
G1 X60 F100
G91 X-20
G90 G3 X0 Y20 I-20
G2 X40 Y0 R20
G52 X10
G1 X40
G52 X0
G92 X100
X80
G10 L2 P1 X4
G92 X30
X40
G81 X20 R2 Z-1
M30
=== truth
rapid 20 0 0
feed 30 0 0 t 6
feed 20 0 0
feed 0 20 0 center 0 0 0 sweep 90
feed 20 0 0 center 0 0 0 sweep -90
feed 25 0 0
feed 15 0 0
feed 20 0 0
rapid 10 0 0
rapid 10 0 2
feed 10 0 -1
rapid 10 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 20 0 0 t0.08
2: feed to 30 0 0 F100 t6
3: feed to 20 0 0 F100 t6
4: feed arc to 0 20 0 center 0 0 0 normal 0 0 1 sweep 90 F100 t18.8496
5: feed arc to 20 0 0 center 0 0 0 normal 0 0 1 sweep -90 F100 t18.8496
7: feed to 25 0 0 F100 t3
10: feed to 15 0 0 F100 t6
13: feed to 20 0 0 F100 t3
14: rapid to 10 0 0 t0.04
14: rapid to 10 0 2 t0.008
14: feed to 10 0 -1 F100 t1.8
14: rapid to 10 0 0 t0.004
15: event end code="M30"
end of program: 15 blocks, 12 motions, 0 errors, 0 warnings
