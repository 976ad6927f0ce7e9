=== about
An exact turn back is an outer corner of two points.
proves: nct-15.5.1-G41 nct-15.5.2-acute
=== settings
D1 = 5
=== main
G0 X-50
G41 G1 X0 D1 F100
X-50
G40 X-80
M30
=== truth
-50 0 0
5 5 0
5 -5 0
-50 -5 0
-80 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -50 0 0 t0.2
2: feed to 5 5 0 F100 t33.1361
2: feed to 5 -5 0 F100 t6
3: feed to -50 -5 0 F100 t33
4: feed to -80 0 0 F100 t18.2483
5: event end code="M30"
end of program: 5 blocks, 5 motions, 0 errors, 0 warnings
