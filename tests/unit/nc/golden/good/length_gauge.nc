=== about
The control point is the tip: offset 120 makes up for the gauge length 120.
proves: nct-12.2-M6 nct-12.1-T
=== settings
H1 = 120
gauge1 = 120
start = 0 0 200
=== main
T1 M6
G43 G0 Z10 H1
G1 Z-1 F100
M30
=== truth
0 0 10
0 0 -1
=== expect
file 0 main.nc
1: event tool tool=1
2: rapid from 0 0 80 to 0 0 10 t0.28
3: feed to 0 0 -1 F100 t6.6
4: event end code="M30"
end of program: 4 blocks, 2 motions, 0 errors, 0 warnings
