=== about
proves: nct-15.5-parplane
=== settings
axis = U 4 linear parallel X
D1 = 2
=== main
G17 G90 G0 U-20 Y0
G41 G1 U0 Y0 D1 F100
U20
Y20
G3 U0 Y40 I-20 J0
G40 G1 U-20
M30
=== truth
-20 0 0
0 2 0
18 2 0
18 20 0
0 38 0 center 0 20 0 sweep 90
-20 40 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -20 0 0 t0.08
2: feed to 0 2 0 F100 t12.0599
3: feed to 18 2 0 F100 t10.8
4: feed to 18 20 0 F100 t10.8
5: feed arc to 0 38 0 center 0 20 0 normal 0 0 1 sweep 90 F90 t18.8496
6: feed to -20 40 0 F100 t12.0599
7: event end code="M30"
end of program: 7 blocks, 6 motions, 0 errors, 0 warnings
