=== about
proves: nct-15.5.2-newD
=== settings
D1 = 10
H1 = 0
D2 = 5
=== main
G0 X-100 Y0 F100
G41 X-50 D1
G1 X0
X50 D2
Y50
G40 X0
M30
=== truth
-100 0 0
-50 10 0
0 10 0
45 5 0
45 50 0
0 50 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: rapid to -50 10 0 t0.2
3: feed to 0 10 0 F100 t30
4: feed to 45 5 0 F100 t27.1662
5: feed to 45 50 0 F100 t27
6: feed to 0 50 0 F100 t27
7: event end code="M30"
end of program: 7 blocks, 6 motions, 0 errors, 0 warnings
