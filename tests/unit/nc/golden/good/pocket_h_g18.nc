=== about
P-H
proves: nct-23.6-P9999
=== settings
D1 = 5
=== main
G18 G90
G0 X0 Z0 Y2
G65 P9999 Z60 X40 Y10 J2 R8 D1 E60 Q4 F400
M30
=== truth
rapid 0 2 0
feed 0.0000 -3.3333 0.0000
feed 0.0000 -3.3333 -10.0000
feed 0.0000 -3.3333 10.0000
feed 0.0000 -3.3333 15.0000
feed 5.0000 -3.3333 15.0000
feed 5.0000 -3.3333 -15.0000
feed -5.0000 -3.3333 -15.0000
feed -5.0000 -3.3333 15.0000
feed 0.0000 -3.3333 15.0000
feed 0.0000 -3.3333 20.0000
feed 10.0000 -3.3333 20.0000
feed 10.0000 -3.3333 -20.0000
feed -10.0000 -3.3333 -20.0000
feed -10.0000 -3.3333 20.0000
feed 0.0000 -3.3333 20.0000
feed 0.0000 -3.3333 25.0000
feed 12.0000 -3.3333 25.0000
feed 15.0000 -3.3333 22.0000
feed 15.0000 -3.3333 -22.0000
feed 12.0000 -3.3333 -25.0000
feed -12.0000 -3.3333 -25.0000
feed -15.0000 -3.3333 -22.0000
feed -15.0000 -3.3333 22.0000
feed -12.0000 -3.3333 25.0000
feed 0.0000 -3.3333 25.0000
rapid 0.0000 -1.3333 25.0000
rapid 0.0000 -1.3333 0.0000
feed 0.0000 -6.6667 0.0000
feed 0.0000 -6.6667 -10.0000
feed 0.0000 -6.6667 10.0000
feed 0.0000 -6.6667 15.0000
feed 5.0000 -6.6667 15.0000
feed 5.0000 -6.6667 -15.0000
feed -5.0000 -6.6667 -15.0000
feed -5.0000 -6.6667 15.0000
feed 0.0000 -6.6667 15.0000
feed 0.0000 -6.6667 20.0000
feed 10.0000 -6.6667 20.0000
feed 10.0000 -6.6667 -20.0000
feed -10.0000 -6.6667 -20.0000
feed -10.0000 -6.6667 20.0000
feed 0.0000 -6.6667 20.0000
feed 0.0000 -6.6667 25.0000
feed 12.0000 -6.6667 25.0000
feed 15.0000 -6.6667 22.0000
feed 15.0000 -6.6667 -22.0000
feed 12.0000 -6.6667 -25.0000
feed -12.0000 -6.6667 -25.0000
feed -15.0000 -6.6667 -22.0000
feed -15.0000 -6.6667 22.0000
feed -12.0000 -6.6667 25.0000
feed 0.0000 -6.6667 25.0000
rapid 0.0000 -4.6667 25.0000
rapid 0.0000 -4.6667 0.0000
feed 0.0000 -10.0000 0.0000
feed 0.0000 -10.0000 -10.0000
feed 0.0000 -10.0000 10.0000
feed 0.0000 -10.0000 15.0000
feed 5.0000 -10.0000 15.0000
feed 5.0000 -10.0000 -15.0000
feed -5.0000 -10.0000 -15.0000
feed -5.0000 -10.0000 15.0000
feed 0.0000 -10.0000 15.0000
feed 0.0000 -10.0000 20.0000
feed 10.0000 -10.0000 20.0000
feed 10.0000 -10.0000 -20.0000
feed -10.0000 -10.0000 -20.0000
feed -10.0000 -10.0000 20.0000
feed 0.0000 -10.0000 20.0000
feed 0.0000 -10.0000 25.0000
feed 12.0000 -10.0000 25.0000
feed 15.0000 -10.0000 22.0000
feed 15.0000 -10.0000 -22.0000
feed 12.0000 -10.0000 -25.0000
feed -12.0000 -10.0000 -25.0000
feed -15.0000 -10.0000 -22.0000
feed -15.0000 -10.0000 22.0000
feed -12.0000 -10.0000 25.0000
feed 0.0000 -10.0000 25.0000
rapid 0.0000 2.0000 25.0000
rapid 0.0000 2.0000 0.0000
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 0 2 0 t0.008
file 1 O9999 (built in)
1/6 depth 1: feed to 0 -3.3333 0 F200 t1.6
1/8 depth 1: feed to 0 -3.3333 -10 F200 t3
1/9 depth 1: feed to 0 -3.3333 10 F200 t6
1/21 depth 1: feed to 0 -3.3333 15 F400 t0.75
1/22 depth 1: feed to 5 -3.3333 15 F400 t0.75
1/24 depth 1: feed to 5 -3.3333 -15 F400 t4.5
1/26 depth 1: feed to -5 -3.3333 -15 F400 t1.5
1/28 depth 1: feed to -5 -3.3333 15 F400 t4.5
1/30 depth 1: feed to 0 -3.3333 15 F400 t0.75
1/21 depth 1: feed to 0 -3.3333 20 F400 t0.75
1/22 depth 1: feed to 10 -3.3333 20 F400 t1.5
1/24 depth 1: feed to 10 -3.3333 -20 F400 t6
1/26 depth 1: feed to -10 -3.3333 -20 F400 t3
1/28 depth 1: feed to -10 -3.3333 20 F400 t6
1/30 depth 1: feed to 0 -3.3333 20 F400 t1.5
1/21 depth 1: feed to 0 -3.3333 25 F400 t0.75
1/22 depth 1: feed to 12 -3.3333 25 F400 t1.8
1/23 depth 1: feed arc to 15 -3.3333 22 center 12 -3.3333 22 normal 0 1 0 sweep 90 F400 t0.7069
1/24 depth 1: feed to 15 -3.3333 -22 F400 t6.6
1/25 depth 1: feed arc to 12 -3.3333 -25 center 12 -3.3333 -22 normal 0 1 0 sweep 90 F400 t0.7069
1/26 depth 1: feed to -12 -3.3333 -25 F400 t3.6
1/27 depth 1: feed arc to -15 -3.3333 -22 center -12 -3.3333 -22 normal 0 1 0 sweep 90 F400 t0.7069
1/28 depth 1: feed to -15 -3.3333 22 F400 t6.6
1/29 depth 1: feed arc to -12 -3.3333 25 center -12 -3.3333 22 normal 0 1 0 sweep 90 F400 t0.7069
1/30 depth 1: feed to 0 -3.3333 25 F400 t1.8
1/34 depth 1: rapid to 0 -1.3333 25 t0.008
1/35 depth 1: rapid to 0 -1.3333 0 t0.1
1/6 depth 1: feed to 0 -6.6667 0 F200 t1.6
1/8 depth 1: feed to 0 -6.6667 -10 F200 t3
1/9 depth 1: feed to 0 -6.6667 10 F200 t6
1/21 depth 1: feed to 0 -6.6667 15 F400 t0.75
1/22 depth 1: feed to 5 -6.6667 15 F400 t0.75
1/24 depth 1: feed to 5 -6.6667 -15 F400 t4.5
1/26 depth 1: feed to -5 -6.6667 -15 F400 t1.5
1/28 depth 1: feed to -5 -6.6667 15 F400 t4.5
1/30 depth 1: feed to 0 -6.6667 15 F400 t0.75
1/21 depth 1: feed to 0 -6.6667 20 F400 t0.75
1/22 depth 1: feed to 10 -6.6667 20 F400 t1.5
1/24 depth 1: feed to 10 -6.6667 -20 F400 t6
1/26 depth 1: feed to -10 -6.6667 -20 F400 t3
1/28 depth 1: feed to -10 -6.6667 20 F400 t6
1/30 depth 1: feed to 0 -6.6667 20 F400 t1.5
1/21 depth 1: feed to 0 -6.6667 25 F400 t0.75
1/22 depth 1: feed to 12 -6.6667 25 F400 t1.8
1/23 depth 1: feed arc to 15 -6.6667 22 center 12 -6.6667 22 normal 0 1 0 sweep 90 F400 t0.7069
1/24 depth 1: feed to 15 -6.6667 -22 F400 t6.6
1/25 depth 1: feed arc to 12 -6.6667 -25 center 12 -6.6667 -22 normal 0 1 0 sweep 90 F400 t0.7069
1/26 depth 1: feed to -12 -6.6667 -25 F400 t3.6
1/27 depth 1: feed arc to -15 -6.6667 -22 center -12 -6.6667 -22 normal 0 1 0 sweep 90 F400 t0.7069
1/28 depth 1: feed to -15 -6.6667 22 F400 t6.6
1/29 depth 1: feed arc to -12 -6.6667 25 center -12 -6.6667 22 normal 0 1 0 sweep 90 F400 t0.7069
1/30 depth 1: feed to 0 -6.6667 25 F400 t1.8
1/34 depth 1: rapid to 0 -4.6667 25 t0.008
1/35 depth 1: rapid to 0 -4.6667 0 t0.1
1/6 depth 1: feed to 0 -10 0 F200 t1.6
1/8 depth 1: feed to 0 -10 -10 F200 t3
1/9 depth 1: feed to 0 -10 10 F200 t6
1/21 depth 1: feed to 0 -10 15 F400 t0.75
1/22 depth 1: feed to 5 -10 15 F400 t0.75
1/24 depth 1: feed to 5 -10 -15 F400 t4.5
1/26 depth 1: feed to -5 -10 -15 F400 t1.5
1/28 depth 1: feed to -5 -10 15 F400 t4.5
1/30 depth 1: feed to 0 -10 15 F400 t0.75
1/21 depth 1: feed to 0 -10 20 F400 t0.75
1/22 depth 1: feed to 10 -10 20 F400 t1.5
1/24 depth 1: feed to 10 -10 -20 F400 t6
1/26 depth 1: feed to -10 -10 -20 F400 t3
1/28 depth 1: feed to -10 -10 20 F400 t6
1/30 depth 1: feed to 0 -10 20 F400 t1.5
1/21 depth 1: feed to 0 -10 25 F400 t0.75
1/22 depth 1: feed to 12 -10 25 F400 t1.8
1/23 depth 1: feed arc to 15 -10 22 center 12 -10 22 normal 0 1 0 sweep 90 F400 t0.7069
1/24 depth 1: feed to 15 -10 -22 F400 t6.6
1/25 depth 1: feed arc to 12 -10 -25 center 12 -10 -22 normal 0 1 0 sweep 90 F400 t0.7069
1/26 depth 1: feed to -12 -10 -25 F400 t3.6
1/27 depth 1: feed arc to -15 -10 -22 center -12 -10 -22 normal 0 1 0 sweep 90 F400 t0.7069
1/28 depth 1: feed to -15 -10 22 F400 t6.6
1/29 depth 1: feed arc to -12 -10 25 center -12 -10 22 normal 0 1 0 sweep 90 F400 t0.7069
1/30 depth 1: feed to 0 -10 25 F400 t1.8
1/34 depth 1: rapid to 0 2 25 t0.048
1/35 depth 1: rapid to 0 2 0 t0.1
4: event end code="M30"
end of program: 237 blocks, 82 motions, 0 errors, 0 warnings
