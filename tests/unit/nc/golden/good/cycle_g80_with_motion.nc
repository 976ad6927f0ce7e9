=== about
The motion runs under the group-1 code from before the cycle.
proves: nct-18.1.4-G80
=== main
G0 Z10
G81 X5 Z-1 R2 F100
G80 X50
M30
=== truth
0 0 10
5 0 10
5 0 2
5 0 -1
5 0 10
rapid 50 0 10
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 10 t0.04
2: rapid to 5 0 10 t0.02
2: rapid to 5 0 2 t0.032
2: feed to 5 0 -1 F100 t1.8
2: rapid to 5 0 10 t0.044
3: rapid to 50 0 10 t0.18
4: event end code="M30"
end of program: 4 blocks, 6 motions, 0 errors, 0 warnings
