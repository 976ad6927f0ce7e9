=== about
A factor of -1 mirrors: G41 runs on the right, G3 becomes G2.
proves: nct-16.2-G51-IJK
=== settings
D1 = 2
=== main
G17 G90 G0 X20 Y0
G51 X0 Y0 I-1 J1
G41 G1 X0 Y0 D1 F100
X10
Y20
G3 X-10 Y40 R20
G40 G1 X-20 Y60
G50
M30
=== truth
20 0 0
0 2 0
-8 2 0
-8 20 0
10 38 0 center 10 20 0 sweep -90
11.2361 38 0
20 60 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 20 0 0 t0.08
3: feed to 0 2 0 F100 t12.0599
4: feed to -8 2 0 F100 t4.8
5: feed to -8 20 0 F100 t10.8
6: feed arc to 10 38 0 center 10 20 0 normal 0 0 1 sweep -90 F90 t18.8496
6: feed to 11.2361 38 0 F100 t0.7416
7: feed to 20 60 0 F100 t14.2088
9: event end code="M30"
end of program: 9 blocks, 7 motions, 0 errors, 0 warnings
