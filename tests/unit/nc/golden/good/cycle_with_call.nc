=== about
P and L belong to M98 there; the dwell stays 3 s.
proves: nct-18.1.6-G82 nct-14.4.2-M98P
=== main
G0 Z10
G82 X5 Z-1 R2 P3 F100
X10 M98 P11 L2
G80
M30
=== sub O0011.nc
YI1
M99
=== truth
0 0 10
5 0 10
5 0 2
5 0 -1
5 0 10
10 0 10
10 0 2
10 0 -1
10 0 10
10 1 10
10 1 2
10 1 -1
10 1 10
10 2 10
10 2 2
10 2 -1
10 2 10
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 10 t0.04
2: rapid to 5 0 10 t0.02
2: rapid to 5 0 2 t0.032
2: feed to 5 0 -1 F100 t1.8
2: event dwell seconds=3
2: rapid to 5 0 10 t0.044
3: rapid to 10 0 10 t0.02
3: rapid to 10 0 2 t0.032
3: feed to 10 0 -1 F100 t1.8
3: event dwell seconds=3
3: rapid to 10 0 10 t0.044
file 1 O0011.nc
1/1 depth 1: rapid to 10 1 10 t0.004
1/1 depth 1: rapid to 10 1 2 t0.032
1/1 depth 1: feed to 10 1 -1 F100 t1.8
1/1 depth 1: event dwell seconds=3
1/1 depth 1: rapid to 10 1 10 t0.044
1/1 depth 1: rapid to 10 2 10 t0.004
1/1 depth 1: rapid to 10 2 2 t0.032
1/1 depth 1: feed to 10 2 -1 F100 t1.8
1/1 depth 1: event dwell seconds=3
1/1 depth 1: rapid to 10 2 10 t0.044
5: event end code="M30"
end of program: 9 blocks, 17 motions, 0 errors, 0 warnings
