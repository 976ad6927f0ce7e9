=== about
Basic rotation: I about Z, J about Y, K about X.
proves: nct-10.2.3-rotation nct-10.2.4-G10L2
=== main
G90 G10 L2 P1 X0 Y0 I30
G54 G0 X100 Y0
G0 X100 Y50 Z20
G10 L2 P1 I0 J30
G0 X100 Y50 Z20
X0 Y0 Z0
G10 L2 P1 I30 J20 K10
X100 Y50 Z20
M30
=== truth
86.6025 50 0
61.6025 93.3013 20
96.6025 50 -32.6795
0 0 0
66.9017 91.4734 -7.5349
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 86.6025 50 0 t0.3464
3: rapid to 61.6025 93.3013 20 t0.1732
5: rapid to 96.6025 50 -32.6795 t0.2107
6: rapid to 0 0 0 t0.3864
8: rapid to 66.9017 91.4734 -7.5349 t0.3659
9: event end code="M30"
end of program: 9 blocks, 5 motions, 0 errors, 0 warnings
