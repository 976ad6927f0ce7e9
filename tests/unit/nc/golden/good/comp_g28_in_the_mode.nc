=== about
The vector is dropped before G28 and is back at the end of the next motion.
proves: nct-9.1-G28
=== settings
D1 = 10
H1 = 0
reference1 = 400 300 200
=== main
G0 X-100 Y0 F100
G41 X-50 D1
G1 X0
G91 G28 Y0
G90 G1 X0 Y0
X50
G40 X80
M30
=== truth
-100 0 0
-50 10 0
0 0 0
0 300 0
10 10 0
50 10 0
80 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: rapid to -50 10 0 t0.2
3: feed to 0 0 0 F100 t30.5941
4: rapid to 0 300 0 t1.2
5: feed to 10 10 0 F100 t174.1034
6: feed to 50 10 0 F100 t24
7: feed to 80 0 0 F100 t18.9737
8: event end code="M30"
end of program: 8 blocks, 7 motions, 0 errors, 0 warnings
