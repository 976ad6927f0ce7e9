=== about
Basic rotations of (100,50,20): K turns about X, J about Y, I about Z, in this order.
proves: nct-10.2.3-rotation nct-10.2.4-G10L2
=== main
G0 G54
G10 L2 P1 K30
X100 Y50 Z20
G10 L2 P1 J90 K90
X100 Y50 Z20
G10 L2 P1 I30 J0 K0
X100 Y50 Z20
G10 L2 P1 I0 J30
X100 Y50 Z20
G10 L2 P1 I30 J20 K10
X100 Y50 Z20
M30
=== truth
100 33.3013 42.3205
50 -20 -100
61.6025 93.3013 20
96.6025 50 -32.6795
66.9017 91.4734 -7.5349
=== expect
file 0 main.nc
3: rapid from 0 0 0 to 100 33.3013 42.3205 t0.4
5: rapid to 50 -20 -100 t0.5693
7: rapid to 61.6025 93.3013 20 t0.48
9: rapid to 96.6025 50 -32.6795 t0.2107
11: rapid to 66.9017 91.4734 -7.5349 t0.1659
12: event end code="M30"
end of program: 12 blocks, 5 motions, 0 errors, 0 warnings
