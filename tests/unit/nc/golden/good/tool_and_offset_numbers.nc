=== about
Numbers of tools with up to eight digits, leading zeros left out or not; offsets of rows 1 to 999, row 0 is none.
proves: nct-1.1-T nct-1.1-HD
=== settings
H999 = 9
H1 = 1
D999 = 3
=== main
T12345678 M6
G1 X1 F100
T0012 M06
X2
G43 Z10 H999
Z10 H001
Z10 H0
G49
G41 X12 Y0 D999
X20
G40 X30
M30
=== truth
1 0 0 T 12345678
2 0 0 T 12
2 0 19
2 0 11
2 0 10
12 3 10
20 3 10
30 0 10
=== expect
file 0 main.nc
1: event tool tool=12345678
2: feed from 0 0 0 to 1 0 0 F100 t0.6
3: event tool tool=12
4: feed to 2 0 0 F100 t0.6
5: feed to 2 0 19 F100 t11.4
6: feed to 2 0 11 F100 t4.8
7: feed to 2 0 10 F100 t0.6
9: feed to 12 3 10 F100 t6.2642
10: feed to 20 3 10 F100 t4.8
11: feed to 30 0 10 F100 t6.2642
12: event end code="M30"
end of program: 12 blocks, 8 motions, 0 errors, 0 warnings
