=== about
proves: nct-15.5-G42 nct-14.4.2-M98P
=== settings
D1 = 5
H1 = 0
=== main
G0 X-40 Y-40 F100
G42 X0 Y0 D1
M98 P11
Y0
G40 G0 X-40 Y-40
M30
=== sub O0011.nc
G1 X60
Y60
X0
M99
=== truth
-40 -40 0
0 -5 0
65 -5 0
65 65 0
-5 65 0
-5 0 0
-40 -40 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -40 -40 0 t0.16
file 1 O0011.nc
2: rapid to 0 -5 0 t0.16
1/1 depth 1: feed to 65 -5 0 F100 t39
1/2 depth 1: feed to 65 65 0 F100 t42
1/3 depth 1: feed to -5 65 0 F100 t42
4: feed to -5 0 0 F100 t39
5: rapid to -40 -40 0 t0.16
6: event end code="M30"
end of program: 10 blocks, 7 motions, 0 errors, 0 warnings
