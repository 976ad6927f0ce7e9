=== about
P-G
proves: nct-23.6-P9999
=== settings
D1 = 5
=== main
G17 G90
G0 X0 Y0 Z2
G65 P9999 X50 Y50 Z4 K2 D1 Q4 F400
M30
=== truth
rapid 0 0 2
feed 0.0000 0.0000 -4.0000 F 200
feed 6.6667 0.0000 -4.0000 F 400
feed 6.6667 6.6667 -4.0000 F 400
feed -6.6667 6.6667 -4.0000 F 400
feed -6.6667 -6.6667 -4.0000 F 400
feed 6.6667 -6.6667 -4.0000 F 400
feed 6.6667 0.0000 -4.0000 F 400
feed 13.3333 0.0000 -4.0000 F 400
feed 13.3333 13.3333 -4.0000 F 400
feed -13.3333 13.3333 -4.0000 F 400
feed -13.3333 -13.3333 -4.0000 F 400
feed 13.3333 -13.3333 -4.0000 F 400
feed 13.3333 0.0000 -4.0000 F 400
feed 20.0000 0.0000 -4.0000 F 400
feed 20.0000 20.0000 -4.0000 F 400
feed -20.0000 20.0000 -4.0000 F 400
feed -20.0000 -20.0000 -4.0000 F 400
feed 20.0000 -20.0000 -4.0000 F 400
feed 20.0000 0.0000 -4.0000 F 400
rapid 20.0000 0.0000 2.0000
rapid 0.0000 0.0000 2.0000
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 0 0 2 t0.008
file 1 O9999 (built in)
1/6 depth 1: feed to 0 0 -4 F200 t1.8
1/21 depth 1: feed to 6.6667 0 -4 F400 t1
1/22 depth 1: feed to 6.6667 6.6667 -4 F400 t1
1/24 depth 1: feed to -6.6667 6.6667 -4 F400 t2
1/26 depth 1: feed to -6.6667 -6.6667 -4 F400 t2
1/28 depth 1: feed to 6.6667 -6.6667 -4 F400 t2
1/30 depth 1: feed to 6.6667 0 -4 F400 t1
1/21 depth 1: feed to 13.3333 0 -4 F400 t1
1/22 depth 1: feed to 13.3333 13.3333 -4 F400 t2
1/24 depth 1: feed to -13.3333 13.3333 -4 F400 t4
1/26 depth 1: feed to -13.3333 -13.3333 -4 F400 t4
1/28 depth 1: feed to 13.3333 -13.3333 -4 F400 t4
1/30 depth 1: feed to 13.3333 0 -4 F400 t2
1/21 depth 1: feed to 20 0 -4 F400 t1
1/22 depth 1: feed to 20 20 -4 F400 t3
1/24 depth 1: feed to -20 20 -4 F400 t6
1/26 depth 1: feed to -20 -20 -4 F400 t6
1/28 depth 1: feed to 20 -20 -4 F400 t6
1/30 depth 1: feed to 20 0 -4 F400 t3
1/34 depth 1: rapid to 20 0 2 t0.024
1/35 depth 1: rapid to 0 0 2 t0.08
4: event end code="M30"
end of program: 83 blocks, 22 motions, 0 errors, 0 warnings
