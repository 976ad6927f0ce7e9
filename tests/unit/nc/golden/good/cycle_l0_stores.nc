=== about
proves: nct-18.1.5-G81
=== main
G0 Z10
G81 X5 Z-1 R2 F100 L0
X7
M30
=== truth
0 0 10
7 0 10
7 0 2
7 0 -1
7 0 10
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 10 t0.04
3: rapid to 7 0 10 t0.028
3: rapid to 7 0 2 t0.032
3: feed to 7 0 -1 F100 t1.8
3: rapid to 7 0 10 t0.044
4: event end code="M30"
end of program: 4 blocks, 5 motions, 0 errors, 0 warnings
