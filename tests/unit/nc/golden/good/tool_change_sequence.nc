=== about
In the spindle: 12, 15, 8.
proves: nct-12.1-T nct-12.2-M6
=== main
T12 M6
T15
G0 X1
M6
T8
G0 X2
M6
T9
G0 X3
M30
=== truth
1 0 0 T 12
2 0 0 T 15
3 0 0 T 8
=== expect
file 0 main.nc
1: event tool tool=12
3: rapid from 0 0 0 to 1 0 0 t0.004
4: event tool tool=15
6: rapid to 2 0 0 t0.004
7: event tool tool=8
9: rapid to 3 0 0 t0.004
10: event end code="M30"
end of program: 10 blocks, 3 motions, 0 errors, 0 warnings
