=== about
A run is automatic mode: compensation works, and nothing stops between the blocks.
proves: nct-17.1-single nct-18.2-single nct-15.5-mode
=== settings
D1 = 1
=== main
G41 D1 G1 X10 ,R2 F100
Y10
G40 X0
G81 X5 Z-2 R1
M30
=== truth
8 1 0
9 2 0 center 8 2 0 sweep 90
9 10 0
0 10 0
5 10 0
5 10 1
feed 5 10 -2
5 10 0
=== expect
file 0 main.nc
1: feed from 0 0 0 to 8 1 0 F100 t4.8374
1: feed arc to 9 2 0 center 8 2 0 normal 0 0 1 sweep 90 F50 t1.885
2: feed to 9 10 0 F100 t4.8
3: feed to 0 10 0 F100 t5.4
4: rapid to 5 10 0 t0.02
4: rapid to 5 10 1 t0.004
4: feed to 5 10 -2 F100 t1.8
4: rapid to 5 10 0 t0.008
5: event end code="M30"
end of program: 5 blocks, 8 motions, 0 errors, 0 warnings
