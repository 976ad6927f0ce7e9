=== about
P-E
proves: nct-23.6-special
=== settings
D1 = 5
=== main
G17 G90
G0 X0 Y0 Z2
G65 P9999 X50 Z5 K2 R8 D1 Q5 F200
M30
=== truth
rapid 0 0 2
feed 0.0000 0.0000 -5.0000
feed -17.0000 0.0000 -5.0000
feed 17.0000 0.0000 -5.0000
feed 20.0000 0.0000 -5.0000
feed 17.0000 3.0000 -5.0000
feed -17.0000 3.0000 -5.0000
feed -20.0000 0.0000 -5.0000
feed -17.0000 -3.0000 -5.0000
feed 17.0000 -3.0000 -5.0000
feed 20.0000 -0.0000 -5.0000
rapid 20.0000 0.0000 2.0000
rapid 0.0000 0.0000 2.0000
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 0 0 2 t0.008
file 1 O9999 (built in)
1/6 depth 1: feed to 0 0 -5 F100 t4.2
1/8 depth 1: feed to -17 0 -5 F100 t10.2
1/9 depth 1: feed to 17 0 -5 F100 t20.4
1/21 depth 1: feed to 20 0 -5 F200 t0.9
1/23 depth 1: feed arc to 17 3 -5 center 17 0 -5 normal 0 0 1 sweep 90 F200 t1.4137
1/24 depth 1: feed to -17 3 -5 F200 t10.2
1/25 depth 1: feed arc to -20 0 -5 center -17 0 -5 normal 0 0 1 sweep 90 F200 t1.4137
1/27 depth 1: feed arc to -17 -3 -5 center -17 0 -5 normal 0 0 1 sweep 90 F200 t1.4137
1/28 depth 1: feed to 17 -3 -5 F200 t10.2
1/29 depth 1: feed arc to 20 0 -5 center 17 0 -5 normal 0 0 1 sweep 90 F200 t1.4137
1/34 depth 1: rapid to 20 0 2 t0.028
1/35 depth 1: rapid to 0 0 2 t0.08
4: event end code="M30"
end of program: 43 blocks, 13 motions, 0 errors, 0 warnings
