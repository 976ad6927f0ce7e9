=== about
An acute corner has the points (1,1) and (1.4142,0): with N1405 = 2 the later one is left out.
proves: nct-15.5.2-N1405
=== settings
D1 = 1
N1405 = 2
=== main
G0 X-100
G41 G1 X-50 D1 F1000
X0
X-30 Y-30
G40 X-60 Y-60
M30
=== truth
-100 0 0
-50 1 0
1 1 0
-29.2929 -30.7071 0
-60 -60 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: feed to -50 1 0 F1000 t3.0006
3: feed to 1 1 0 F1000 t3.06
4: feed to -29.2929 -30.7071 0 F1000 t2.6311
5: feed to -60 -60 0 F1000 t2.5463
6: event end code="M30"
end of program: 6 blocks, 5 motions, 0 errors, 0 warnings
