=== about
P-C
proves: nct-23.6-special
=== settings
D1 = 5
=== main
G17 G90
G0 X0 Y0 Z2
G65 P9999 Z6 K2 R20 D1 E50 Q3 F300
M30
=== truth
rapid 0 0 2
feed 0.0000 0.0000 -3.0000
feed 5.0000 0.0000 -3.0000
feed 0.0000 5.0000 -3.0000
feed -5.0000 0.0000 -3.0000
feed -0.0000 -5.0000 -3.0000
feed 5.0000 -0.0000 -3.0000
feed 10.0000 0.0000 -3.0000
feed 0.0000 10.0000 -3.0000
feed -10.0000 0.0000 -3.0000
feed -0.0000 -10.0000 -3.0000
feed 10.0000 -0.0000 -3.0000
feed 15.0000 0.0000 -3.0000
feed 0.0000 15.0000 -3.0000
feed -15.0000 0.0000 -3.0000
feed -0.0000 -15.0000 -3.0000
feed 15.0000 -0.0000 -3.0000
rapid 15.0000 0.0000 -1.0000
rapid 0.0000 0.0000 -1.0000
feed 0.0000 0.0000 -6.0000
feed 5.0000 0.0000 -6.0000
feed 0.0000 5.0000 -6.0000
feed -5.0000 0.0000 -6.0000
feed -0.0000 -5.0000 -6.0000
feed 5.0000 -0.0000 -6.0000
feed 10.0000 0.0000 -6.0000
feed 0.0000 10.0000 -6.0000
feed -10.0000 0.0000 -6.0000
feed -0.0000 -10.0000 -6.0000
feed 10.0000 -0.0000 -6.0000
feed 15.0000 0.0000 -6.0000
feed 0.0000 15.0000 -6.0000
feed -15.0000 0.0000 -6.0000
feed -0.0000 -15.0000 -6.0000
feed 15.0000 -0.0000 -6.0000
rapid 15.0000 0.0000 2.0000
rapid 0.0000 0.0000 2.0000
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 0 0 2 t0.008
file 1 O9999 (built in)
1/6 depth 1: feed to 0 0 -3 F150 t2
1/21 depth 1: feed to 5 0 -3 F300 t1
1/23 depth 1: feed arc to 0 5 -3 center 0 0 -3 normal 0 0 1 sweep 90 F300 t1.5708
1/25 depth 1: feed arc to -5 0 -3 center 0 0 -3 normal 0 0 1 sweep 90 F300 t1.5708
1/27 depth 1: feed arc to 0 -5 -3 center 0 0 -3 normal 0 0 1 sweep 90 F300 t1.5708
1/29 depth 1: feed arc to 5 0 -3 center 0 0 -3 normal 0 0 1 sweep 90 F300 t1.5708
1/21 depth 1: feed to 10 0 -3 F300 t1
1/23 depth 1: feed arc to 0 10 -3 center 0 0 -3 normal 0 0 1 sweep 90 F300 t3.1416
1/25 depth 1: feed arc to -10 0 -3 center 0 0 -3 normal 0 0 1 sweep 90 F300 t3.1416
1/27 depth 1: feed arc to 0 -10 -3 center 0 0 -3 normal 0 0 1 sweep 90 F300 t3.1416
1/29 depth 1: feed arc to 10 0 -3 center 0 0 -3 normal 0 0 1 sweep 90 F300 t3.1416
1/21 depth 1: feed to 15 0 -3 F300 t1
1/23 depth 1: feed arc to 0 15 -3 center 0 0 -3 normal 0 0 1 sweep 90 F300 t4.7124
1/25 depth 1: feed arc to -15 0 -3 center 0 0 -3 normal 0 0 1 sweep 90 F300 t4.7124
1/27 depth 1: feed arc to 0 -15 -3 center 0 0 -3 normal 0 0 1 sweep 90 F300 t4.7124
1/29 depth 1: feed arc to 15 0 -3 center 0 0 -3 normal 0 0 1 sweep 90 F300 t4.7124
1/34 depth 1: rapid to 15 0 -1 t0.008
1/35 depth 1: rapid to 0 0 -1 t0.06
1/6 depth 1: feed to 0 0 -6 F150 t2
1/21 depth 1: feed to 5 0 -6 F300 t1
1/23 depth 1: feed arc to 0 5 -6 center 0 0 -6 normal 0 0 1 sweep 90 F300 t1.5708
1/25 depth 1: feed arc to -5 0 -6 center 0 0 -6 normal 0 0 1 sweep 90 F300 t1.5708
1/27 depth 1: feed arc to 0 -5 -6 center 0 0 -6 normal 0 0 1 sweep 90 F300 t1.5708
1/29 depth 1: feed arc to 5 0 -6 center 0 0 -6 normal 0 0 1 sweep 90 F300 t1.5708
1/21 depth 1: feed to 10 0 -6 F300 t1
1/23 depth 1: feed arc to 0 10 -6 center 0 0 -6 normal 0 0 1 sweep 90 F300 t3.1416
1/25 depth 1: feed arc to -10 0 -6 center 0 0 -6 normal 0 0 1 sweep 90 F300 t3.1416
1/27 depth 1: feed arc to 0 -10 -6 center 0 0 -6 normal 0 0 1 sweep 90 F300 t3.1416
1/29 depth 1: feed arc to 10 0 -6 center 0 0 -6 normal 0 0 1 sweep 90 F300 t3.1416
1/21 depth 1: feed to 15 0 -6 F300 t1
1/23 depth 1: feed arc to 0 15 -6 center 0 0 -6 normal 0 0 1 sweep 90 F300 t4.7124
1/25 depth 1: feed arc to -15 0 -6 center 0 0 -6 normal 0 0 1 sweep 90 F300 t4.7124
1/27 depth 1: feed arc to 0 -15 -6 center 0 0 -6 normal 0 0 1 sweep 90 F300 t4.7124
1/29 depth 1: feed arc to 15 0 -6 center 0 0 -6 normal 0 0 1 sweep 90 F300 t4.7124
1/34 depth 1: rapid to 15 0 2 t0.032
1/35 depth 1: rapid to 0 0 2 t0.06
4: event end code="M30"
end of program: 157 blocks, 37 motions, 0 errors, 0 warnings
