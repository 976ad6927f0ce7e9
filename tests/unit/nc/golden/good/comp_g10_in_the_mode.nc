=== about
A new origin ends the look-ahead; the vector is back at the end of the next motion.
proves: nct-10.2.4-G10L2
=== settings
D1 = 10
H1 = 0
=== main
G0 X-100 Y0 F100
G41 X-50 D1
G1 X0
G10 L2 P1 X20
X80
G40 X100
M30
=== truth
-100 0 0
-50 10 0
0 0 0
100 10 0
120 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: rapid to -50 10 0 t0.2
3: feed to 0 0 0 F100 t30.5941
5: feed to 100 10 0 F100 t60.2993
6: feed to 120 0 0 F100 t13.4164
7: event end code="M30"
end of program: 7 blocks, 5 motions, 0 errors, 0 warnings
