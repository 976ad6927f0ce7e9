=== about
Digest nct-5, section 13: the motions of a modal macro call the one activated before it; G67 without any does nothing.
proves: nct-23.3.2-G66 nct-23.3.2-G67
=== main
N10 G66 P2
N11 G1 G91 Z10 F100
N12 G66 P3
N13 Z20
N14 G67
N15 G67
N16 Z-5
G67
N17 X1
M30
=== sub O0002
N20 X4
N21 M99
=== sub O0003
N30 Z2
N31 Z3
N32 M99
=== truth
feed 0 0 10
feed 4 0 10
feed 4 0 30
feed 4 0 32
feed 8 0 32
feed 8 0 35
feed 12 0 35
feed 12 0 30
feed 13 0 30
=== expect
file 0 main.nc
file 1 O0002
2 N11: feed from 0 0 0 to 0 0 10 F100 t6
1/1 N20 depth 1: feed to 4 0 10 F100 t2.4
file 2 O0003
4 N13: feed to 4 0 30 F100 t12
2/1 N30 depth 1: feed to 4 0 32 F100 t1.2
1/1 N20 depth 2: feed to 8 0 32 F100 t2.4
2/2 N31 depth 1: feed to 8 0 35 F100 t1.8
1/1 N20 depth 2: feed to 12 0 35 F100 t2.4
7 N16: feed to 12 0 30 F100 t3
9 N17: feed to 13 0 30 F100 t0.6
10: event end code="M30"
end of program: 19 blocks, 9 motions, 0 errors, 0 warnings
