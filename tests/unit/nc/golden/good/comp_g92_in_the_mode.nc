=== about
The vector is dropped before G92 and is back at the end of N130.
proves: nct-3-G92
=== settings
D1 = 10
H1 = 0
=== main
G0 X-100 Y0 F100
G41 X-50 D1
G1 X0
N110 G1 G91 X80 Y-50
N120 G92 X0 Y0
N130 X80 Y50
X50
G40 X50
M30
=== truth
-100 0 0
-50 10 0
2.8680 10 0
80 -50 0
157.1320 10 0
210 10 0
260 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: rapid to -50 10 0 t0.2
3: feed to 2.868 10 0 F100 t31.7208
4 N110: feed to 80 -50 0 F100 t58.6325
6 N130: feed to 157.132 10 0 F100 t58.6325
7: feed to 210 10 0 F100 t31.7208
8: feed to 260 0 0 F100 t30.5941
9: event end code="M30"
end of program: 9 blocks, 7 motions, 0 errors, 0 warnings
