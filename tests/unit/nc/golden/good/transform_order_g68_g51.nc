=== about
proves: nct-16.4-order
=== main
N1 G90 G17 G0 X0 Y0
N2 G68 X80 Y20 R75
N3 G51 X130 Y50 P0.5
N4 X180 Y20
N5 G1 Y80 F200
N6 X80
N7 Y20
N8 X180
N9 G50
N10 G69 G0 X0 Y0
M30
=== truth
84.9225 96.3267 0
55.9448 104.0913 0
43.0038 55.7950 0
71.9816 48.0304 0
84.9225 96.3267 0
0 0 0
=== expect
file 0 main.nc
4 N4: rapid from 0 0 0 to 84.9225 96.3267 0 t0.3853
5 N5: feed to 55.9448 104.0913 0 F200 t9
6 N6: feed to 43.0038 55.795 0 F200 t15
7 N7: feed to 71.9816 48.0304 0 F200 t9
8 N8: feed to 84.9225 96.3267 0 F200 t15
10 N10: rapid to 0 0 0 t0.3853
11: event end code="M30"
end of program: 11 blocks, 6 motions, 0 errors, 0 warnings
