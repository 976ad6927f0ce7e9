=== about
proves: nct-3-G39 nct-15.5.6-G39
=== settings
D1 = 5
=== main
G17 G90 G0 X-50 Y0
G41 G1 X0 D1 F100
N110 G91 X100
N120 G39
N130 G3 X80 Y-80 I80
G40 G1 Y-20
M30
=== truth
-50 0 0
0 5 0
100 5 0
105 0 0 center 100 0 0 sweep -90
180 -75 0 center 180 0 0 sweep 90
185 -75 0
180 -100 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -50 0 0 t0.2
2: feed to 0 5 0 F100 t30.1496
3 N110: feed to 100 5 0 F100 t60
4 N120: feed arc to 105 0 0 center 100 0 0 normal 0 0 1 sweep -90 F100 t4.7124
5 N130: feed arc to 180 -75 0 center 180 0 0 normal 0 0 1 sweep 90 F93.75 t75.3982
5 N130: feed to 185 -75 0 F100 t3
6: feed to 180 -100 0 F100 t15.2971
7: event end code="M30"
end of program: 7 blocks, 7 motions, 0 errors, 0 warnings
