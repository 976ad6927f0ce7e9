=== about
The manual's hexagon: the radius stays in force.
proves: nct-5.4-G16
=== main
N1 G90 G17 G0 X120 Y120 F120
N2 G16 G1 X100 Y60
N3 Y120
N4 Y180
N5 Y240
N6 Y300
N7 Y0
N8 Y60
N9 G15 G0 X120 Y120
M30
=== truth
rapid 120 120 0
feed 50 86.6025 0
feed -50 86.6025 0
feed -100 0 0
feed -50 -86.6025 0
feed 50 -86.6025 0
feed 100 0 0
feed 50 86.6025 0
rapid 120 120 0
=== expect
file 0 main.nc
1 N1: rapid from 0 0 0 to 120 120 0 t0.48
2 N2: feed to 50 86.6025 0 F120 t38.7795
3 N3: feed to -50 86.6025 0 F120 t50
4 N4: feed to -100 0 0 F120 t50
5 N5: feed to -50 -86.6025 0 F120 t50
6 N6: feed to 50 -86.6025 0 F120 t50
7 N7: feed to 100 0 0 F120 t50
8 N8: feed to 50 86.6025 0 F120 t50
9 N9: rapid to 120 120 0 t0.28
10: event end code="M30"
end of program: 10 blocks, 9 motions, 0 errors, 0 warnings
