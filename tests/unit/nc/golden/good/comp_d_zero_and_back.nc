=== about
proves: nct-15.5-D0 nct-15.5.2-newD
=== settings
D1 = 10
H1 = 0
=== main
G0 X-100 Y0 F100
G41 X-50 D1
G1 X0
X50 D0
Y50 D1
X0
G40 X-50
M30
=== truth
-100 0 0
-50 10 0
0 10 0
50 0 0
40 40 0
0 40 0
-50 50 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: rapid to -50 10 0 t0.2
3: feed to 0 10 0 F100 t30
4: feed to 50 0 0 F100 t30.5941
5: feed to 40 40 0 F100 t24.7386
6: feed to 0 40 0 F100 t24
7: feed to -50 50 0 F100 t30.5941
8: event end code="M30"
end of program: 8 blocks, 7 motions, 0 errors, 0 warnings
