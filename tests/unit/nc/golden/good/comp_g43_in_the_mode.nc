=== about
proves: nct-15.5.2-flush nct-15.3-G43
=== settings
D1 = 10
H1 = 0
H2 = 20
=== main
G0 X-100 Y0 F100
G41 X-50 D1
G1 X0
G43 Z5 H2
X50
G40 X80
M30
=== truth
-100 0 0
-50 10 0
0 0 0
0 0 25
50 10 25
80 0 25
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: rapid to -50 10 0 t0.2
3: feed to 0 0 0 F100 t30.5941
4: feed to 0 0 25 F100 t15
5: feed to 50 10 25 F100 t30.5941
6: feed to 80 0 25 F100 t18.9737
7: event end code="M30"
end of program: 7 blocks, 6 motions, 0 errors, 0 warnings
