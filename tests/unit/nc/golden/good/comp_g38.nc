=== about
proves: nct-3-G38 nct-15.5.5-G38
=== settings
D1 = 5
=== main
G17 G90 G0 X-60 Y0
G42 G1 X-40 D1 F100
X0
N110 G91 X40
N120 G38 X50
N130 G38 Y70
N140 G38 Y-70
N150 X60
G40 X10
M30
=== truth
-60 0 0
-40 -5 0
0 -5 0
40 -5 0
90 -5 0
90 65 0
90 -5 0
150 -5 0
160 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -60 0 0 t0.24
2: feed to -40 -5 0 F100 t12.3693
3: feed to 0 -5 0 F100 t24
4 N110: feed to 40 -5 0 F100 t24
5 N120: feed to 90 -5 0 F100 t30
6 N130: feed to 90 65 0 F100 t42
7 N140: feed to 90 -5 0 F100 t42
8 N150: feed to 150 -5 0 F100 t36
9: feed to 160 0 0 F100 t6.7082
10: event end code="M30"
end of program: 10 blocks, 9 motions, 0 errors, 0 warnings
