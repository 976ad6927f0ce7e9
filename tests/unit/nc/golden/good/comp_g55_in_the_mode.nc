=== about
proves: nct-3-G55
=== settings
D1 = 10
H1 = 0
G55 = 100 0 0
=== main
G0 X-100 Y0 F100
G41 X-50 D1
G1 X0
G55 X-50
G40 X0
M30
=== truth
-100 0 0
-50 10 0
0 0 0
50 10 0
100 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: rapid to -50 10 0 t0.2
3: feed to 0 0 0 F100 t30.5941
4: feed to 50 10 0 F100 t30.5941
5: feed to 100 0 0 F100 t30.5941
6: event end code="M30"
end of program: 6 blocks, 5 motions, 0 errors, 0 warnings
