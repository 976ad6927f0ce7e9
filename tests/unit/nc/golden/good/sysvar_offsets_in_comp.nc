=== about
A zero point written while cutter compensation is on: the path before is finished first, then goes on from there.
proves: nct-23.1.19-#5221
=== settings
D1 = 2
=== main
G0 X0 Y0
G1 G41 D1 X10 F100
X20
#5222=5
X30
G40 X40
M30
=== truth
10 2 0
20 0 0
30 2 0
40 0 0
=== expect
file 0 main.nc
2: feed from 0 0 0 to 10 2 0 F100 t6.1188
3: feed to 20 0 0 F100 t6.1188
5: feed to 30 2 0 F100 t6.1188
6: feed to 40 0 0 F100 t6.1188
7: event end code="M30"
end of program: 7 blocks, 4 motions, 0 errors, 0 warnings
