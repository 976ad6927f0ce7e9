=== about
proves: nct-16.4-order
=== main
N1 G90 G17 G0 X0 Y0
N2 G51 X130 Y50 P0.5
N3 G68 X80 Y20 R75
N4 X180 Y20
N5 G1 Y80 F200
N6 X80
N7 Y20
N8 X180
N9 G69
N10 G50 G0 X0 Y0
M30
=== truth
117.9410 83.2963 0
88.9632 91.0609 0
76.0222 42.7646 0
105 35 0
117.9410 83.2963 0
0 0 0
=== expect
file 0 main.nc
4 N4: rapid from 0 0 0 to 117.941 83.2963 0 t0.4718
5 N5: feed to 88.9632 91.0609 0 F200 t9
6 N6: feed to 76.0222 42.7646 0 F200 t15
7 N7: feed to 105 35 0 F200 t9
8 N8: feed to 117.941 83.2963 0 F200 t15
10 N10: rapid to 0 0 0 t0.4718
11: event end code="M30"
end of program: 11 blocks, 6 motions, 0 errors, 0 warnings
