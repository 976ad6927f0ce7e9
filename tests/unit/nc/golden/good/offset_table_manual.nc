=== about
The manual's table of offsets: lengths with wear 349.87, 829.898 and 400; radii 4.988, 9.992 and 29.84. The last line of G10 adds
0.5 to a radius of 8.
proves: nct-15.2-G10-L10 nct-15.2-G10-L11 nct-15.2-G10-L12 nct-15.2-G10-L13 nct-15.2-G90-G91-I nct-15.1-table-mill
=== main
G90
G10 L10 P1 R350
G10 L11 P1 R-0.13
G10 L12 P1 R5
G10 L13 P1 R-0.012
G10 L110 P1 R5
G10 L111 P1 R-0.01
G10 L10 P2 R830
G10 L11 P2 R-0.102
G10 L12 P2 R10
G10 L13 P2 R-0.008
G10 L10 P3 R400
G10 L12 P3 R30
G10 L13 P3 R-0.16
G0 G43 Z0 H1
Z0 H2
Z0 H3
G49 Z0
G1 G41 X10 Y0 D1 F1000
X20
D2 X60
X100
D3 X200
X300
G40 Y0
G10 L12 P5 R8
G10 L12 P5 RI0.5
G0 X#12005 Y#21001 Z#22001
M30
=== truth
0 0 349.87
0 0 829.898
0 0 400
0 0 0
10 4.988 0
20 4.988 0
60 9.992 0
100 9.992 0
200 29.84 0
300 29.84 0
300 0 0
8.5 5 -0.01
=== expect
file 0 main.nc
15: rapid from 0 0 0 to 0 0 349.87 t1.3995
16: rapid to 0 0 829.898 t1.9201
17: rapid to 0 0 400 t1.7196
18: rapid to 0 0 0 t1.6
19: feed to 10 4.988 0 F1000 t0.6705
20: feed to 20 4.988 0 F1000 t0.6
21: feed to 60 9.992 0 F1000 t2.4187
22: feed to 100 9.992 0 F1000 t2.4
23: feed to 200 29.84 0 F1000 t6.117
24: feed to 300 29.84 0 F1000 t6
24: feed to 300 0 0 F1000 t1.7904
28: rapid to 8.5 5 -0.01 t1.166
29: event end code="M30"
end of program: 29 blocks, 12 motions, 0 errors, 0 warnings
