=== about
Variables of positions, of the length in force and of zero points count as the words of their axis: X in diameter.
proves: nct-5.3-DIA
=== settings
N0106.DIA.1 = 1
N1416.ZAX = 0
H1 = 4
=== main
G0 X40
Y#5001
Y#5021
Y#5041
#5241=10
G55 X0
Y#5241
Y#5041
Y#5021
G54 G43 X20 H1
Y#5001
Y#5021
Y#5081
G49
G10.9 X0
Y#5021
M30
=== truth
20 0 0
20 40 0
5 40 0
5 10 0
5 0 0
5 10 0
12 10 0
12 20 0
12 24 0
12 4 0
12 12 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 20 0 0 t0.08
2: rapid to 20 40 0 t0.16
6: rapid to 5 40 0 t0.06
7: rapid to 5 10 0 t0.12
8: rapid to 5 0 0 t0.04
9: rapid to 5 10 0 t0.04
10: rapid to 12 10 0 t0.028
11: rapid to 12 20 0 t0.04
12: rapid to 12 24 0 t0.016
13: rapid to 12 4 0 t0.08
16: rapid to 12 12 0 t0.032
17: event end code="M30"
end of program: 17 blocks, 11 motions, 0 errors, 0 warnings
