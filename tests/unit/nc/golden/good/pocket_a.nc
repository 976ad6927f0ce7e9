=== about
Digest nct-5, section 24, P-A: equal steps, half feed for plunging and the core.
proves: nct-23.6-P9999 nct-23.6-feed
=== settings
D1 = 5
=== main
G17 G90
G0 X0 Y0 Z2
G65 P9999 X60 Y40 Z10 K2 R8 D1 E60 Q4 F400
M30
=== truth
rapid 0 0 2
feed 0.0000 0.0000 -3.3333 F 200
feed -10.0000 0.0000 -3.3333 F 200
feed 10.0000 0.0000 -3.3333 F 200
feed 15.0000 0.0000 -3.3333 F 400
feed 15.0000 5.0000 -3.3333 F 400
feed -15.0000 5.0000 -3.3333 F 400
feed -15.0000 -5.0000 -3.3333 F 400
feed 15.0000 -5.0000 -3.3333 F 400
feed 15.0000 0.0000 -3.3333 F 400
feed 20.0000 0.0000 -3.3333 F 400
feed 20.0000 10.0000 -3.3333 F 400
feed -20.0000 10.0000 -3.3333 F 400
feed -20.0000 -10.0000 -3.3333 F 400
feed 20.0000 -10.0000 -3.3333 F 400
feed 20.0000 0.0000 -3.3333 F 400
feed 25.0000 0.0000 -3.3333 F 400
feed 25.0000 12.0000 -3.3333 F 400
feed 22.0000 15.0000 -3.3333 F 400
feed -22.0000 15.0000 -3.3333 F 400
feed -25.0000 12.0000 -3.3333 F 400
feed -25.0000 -12.0000 -3.3333 F 400
feed -22.0000 -15.0000 -3.3333 F 400
feed 22.0000 -15.0000 -3.3333 F 400
feed 25.0000 -12.0000 -3.3333 F 400
feed 25.0000 0.0000 -3.3333 F 400
rapid 25.0000 0.0000 -1.3333
rapid 0.0000 0.0000 -1.3333
feed 0.0000 0.0000 -6.6667 F 200
feed -10.0000 0.0000 -6.6667 F 200
feed 10.0000 0.0000 -6.6667 F 200
feed 15.0000 0.0000 -6.6667 F 400
feed 15.0000 5.0000 -6.6667 F 400
feed -15.0000 5.0000 -6.6667 F 400
feed -15.0000 -5.0000 -6.6667 F 400
feed 15.0000 -5.0000 -6.6667 F 400
feed 15.0000 0.0000 -6.6667 F 400
feed 20.0000 0.0000 -6.6667 F 400
feed 20.0000 10.0000 -6.6667 F 400
feed -20.0000 10.0000 -6.6667 F 400
feed -20.0000 -10.0000 -6.6667 F 400
feed 20.0000 -10.0000 -6.6667 F 400
feed 20.0000 0.0000 -6.6667 F 400
feed 25.0000 0.0000 -6.6667 F 400
feed 25.0000 12.0000 -6.6667 F 400
feed 22.0000 15.0000 -6.6667 F 400
feed -22.0000 15.0000 -6.6667 F 400
feed -25.0000 12.0000 -6.6667 F 400
feed -25.0000 -12.0000 -6.6667 F 400
feed -22.0000 -15.0000 -6.6667 F 400
feed 22.0000 -15.0000 -6.6667 F 400
feed 25.0000 -12.0000 -6.6667 F 400
feed 25.0000 0.0000 -6.6667 F 400
rapid 25.0000 0.0000 -4.6667
rapid 0.0000 0.0000 -4.6667
feed 0.0000 0.0000 -10.0000 F 200
feed -10.0000 0.0000 -10.0000 F 200
feed 10.0000 0.0000 -10.0000 F 200
feed 15.0000 0.0000 -10.0000 F 400
feed 15.0000 5.0000 -10.0000 F 400
feed -15.0000 5.0000 -10.0000 F 400
feed -15.0000 -5.0000 -10.0000 F 400
feed 15.0000 -5.0000 -10.0000 F 400
feed 15.0000 0.0000 -10.0000 F 400
feed 20.0000 0.0000 -10.0000 F 400
feed 20.0000 10.0000 -10.0000 F 400
feed -20.0000 10.0000 -10.0000 F 400
feed -20.0000 -10.0000 -10.0000 F 400
feed 20.0000 -10.0000 -10.0000 F 400
feed 20.0000 0.0000 -10.0000 F 400
feed 25.0000 0.0000 -10.0000 F 400
feed 25.0000 12.0000 -10.0000 F 400
feed 22.0000 15.0000 -10.0000 F 400
feed -22.0000 15.0000 -10.0000 F 400
feed -25.0000 12.0000 -10.0000 F 400
feed -25.0000 -12.0000 -10.0000 F 400
feed -22.0000 -15.0000 -10.0000 F 400
feed 22.0000 -15.0000 -10.0000 F 400
feed 25.0000 -12.0000 -10.0000 F 400
feed 25.0000 0.0000 -10.0000 F 400
rapid 25.0000 0.0000 2.0000
rapid 0.0000 0.0000 2.0000
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 0 0 2 t0.008
file 1 O9999 (built in)
1/6 depth 1: feed to 0 0 -3.3333 F200 t1.6
1/8 depth 1: feed to -10 0 -3.3333 F200 t3
1/9 depth 1: feed to 10 0 -3.3333 F200 t6
1/21 depth 1: feed to 15 0 -3.3333 F400 t0.75
1/22 depth 1: feed to 15 5 -3.3333 F400 t0.75
1/24 depth 1: feed to -15 5 -3.3333 F400 t4.5
1/26 depth 1: feed to -15 -5 -3.3333 F400 t1.5
1/28 depth 1: feed to 15 -5 -3.3333 F400 t4.5
1/30 depth 1: feed to 15 0 -3.3333 F400 t0.75
1/21 depth 1: feed to 20 0 -3.3333 F400 t0.75
1/22 depth 1: feed to 20 10 -3.3333 F400 t1.5
1/24 depth 1: feed to -20 10 -3.3333 F400 t6
1/26 depth 1: feed to -20 -10 -3.3333 F400 t3
1/28 depth 1: feed to 20 -10 -3.3333 F400 t6
1/30 depth 1: feed to 20 0 -3.3333 F400 t1.5
1/21 depth 1: feed to 25 0 -3.3333 F400 t0.75
1/22 depth 1: feed to 25 12 -3.3333 F400 t1.8
1/23 depth 1: feed arc to 22 15 -3.3333 center 22 12 -3.3333 normal 0 0 1 sweep 90 F400 t0.7069
1/24 depth 1: feed to -22 15 -3.3333 F400 t6.6
1/25 depth 1: feed arc to -25 12 -3.3333 center -22 12 -3.3333 normal 0 0 1 sweep 90 F400 t0.7069
1/26 depth 1: feed to -25 -12 -3.3333 F400 t3.6
1/27 depth 1: feed arc to -22 -15 -3.3333 center -22 -12 -3.3333 normal 0 0 1 sweep 90 F400 t0.7069
1/28 depth 1: feed to 22 -15 -3.3333 F400 t6.6
1/29 depth 1: feed arc to 25 -12 -3.3333 center 22 -12 -3.3333 normal 0 0 1 sweep 90 F400 t0.7069
1/30 depth 1: feed to 25 0 -3.3333 F400 t1.8
1/34 depth 1: rapid to 25 0 -1.3333 t0.008
1/35 depth 1: rapid to 0 0 -1.3333 t0.1
1/6 depth 1: feed to 0 0 -6.6667 F200 t1.6
1/8 depth 1: feed to -10 0 -6.6667 F200 t3
1/9 depth 1: feed to 10 0 -6.6667 F200 t6
1/21 depth 1: feed to 15 0 -6.6667 F400 t0.75
1/22 depth 1: feed to 15 5 -6.6667 F400 t0.75
1/24 depth 1: feed to -15 5 -6.6667 F400 t4.5
1/26 depth 1: feed to -15 -5 -6.6667 F400 t1.5
1/28 depth 1: feed to 15 -5 -6.6667 F400 t4.5
1/30 depth 1: feed to 15 0 -6.6667 F400 t0.75
1/21 depth 1: feed to 20 0 -6.6667 F400 t0.75
1/22 depth 1: feed to 20 10 -6.6667 F400 t1.5
1/24 depth 1: feed to -20 10 -6.6667 F400 t6
1/26 depth 1: feed to -20 -10 -6.6667 F400 t3
1/28 depth 1: feed to 20 -10 -6.6667 F400 t6
1/30 depth 1: feed to 20 0 -6.6667 F400 t1.5
1/21 depth 1: feed to 25 0 -6.6667 F400 t0.75
1/22 depth 1: feed to 25 12 -6.6667 F400 t1.8
1/23 depth 1: feed arc to 22 15 -6.6667 center 22 12 -6.6667 normal 0 0 1 sweep 90 F400 t0.7069
1/24 depth 1: feed to -22 15 -6.6667 F400 t6.6
1/25 depth 1: feed arc to -25 12 -6.6667 center -22 12 -6.6667 normal 0 0 1 sweep 90 F400 t0.7069
1/26 depth 1: feed to -25 -12 -6.6667 F400 t3.6
1/27 depth 1: feed arc to -22 -15 -6.6667 center -22 -12 -6.6667 normal 0 0 1 sweep 90 F400 t0.7069
1/28 depth 1: feed to 22 -15 -6.6667 F400 t6.6
1/29 depth 1: feed arc to 25 -12 -6.6667 center 22 -12 -6.6667 normal 0 0 1 sweep 90 F400 t0.7069
1/30 depth 1: feed to 25 0 -6.6667 F400 t1.8
1/34 depth 1: rapid to 25 0 -4.6667 t0.008
1/35 depth 1: rapid to 0 0 -4.6667 t0.1
1/6 depth 1: feed to 0 0 -10 F200 t1.6
1/8 depth 1: feed to -10 0 -10 F200 t3
1/9 depth 1: feed to 10 0 -10 F200 t6
1/21 depth 1: feed to 15 0 -10 F400 t0.75
1/22 depth 1: feed to 15 5 -10 F400 t0.75
1/24 depth 1: feed to -15 5 -10 F400 t4.5
1/26 depth 1: feed to -15 -5 -10 F400 t1.5
1/28 depth 1: feed to 15 -5 -10 F400 t4.5
1/30 depth 1: feed to 15 0 -10 F400 t0.75
1/21 depth 1: feed to 20 0 -10 F400 t0.75
1/22 depth 1: feed to 20 10 -10 F400 t1.5
1/24 depth 1: feed to -20 10 -10 F400 t6
1/26 depth 1: feed to -20 -10 -10 F400 t3
1/28 depth 1: feed to 20 -10 -10 F400 t6
1/30 depth 1: feed to 20 0 -10 F400 t1.5
1/21 depth 1: feed to 25 0 -10 F400 t0.75
1/22 depth 1: feed to 25 12 -10 F400 t1.8
1/23 depth 1: feed arc to 22 15 -10 center 22 12 -10 normal 0 0 1 sweep 90 F400 t0.7069
1/24 depth 1: feed to -22 15 -10 F400 t6.6
1/25 depth 1: feed arc to -25 12 -10 center -22 12 -10 normal 0 0 1 sweep 90 F400 t0.7069
1/26 depth 1: feed to -25 -12 -10 F400 t3.6
1/27 depth 1: feed arc to -22 -15 -10 center -22 -12 -10 normal 0 0 1 sweep 90 F400 t0.7069
1/28 depth 1: feed to 22 -15 -10 F400 t6.6
1/29 depth 1: feed arc to 25 -12 -10 center 22 -12 -10 normal 0 0 1 sweep 90 F400 t0.7069
1/30 depth 1: feed to 25 0 -10 F400 t1.8
1/34 depth 1: rapid to 25 0 2 t0.048
1/35 depth 1: rapid to 0 0 2 t0.1
4: event end code="M30"
end of program: 237 blocks, 82 motions, 0 errors, 0 warnings
