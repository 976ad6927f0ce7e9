=== about
Each true relation moves by one, each false one would move to X100.
proves: nct-23.2.7-EQ nct-23.2.7-NE nct-23.2.7-GT nct-23.2.7-LT nct-23.2.7-GE nct-23.2.7-LE
=== main
#1=-5.4
IF[#1EQ-5.4] G0 X1
IF[#1EQ5.4] X100
IF[#1NE0] X2
IF[#1NE-5.4] X100
IF[#1GT-5.5] X3
IF[#1GT-5.39] X100
IF[#1LT-5.39] X4
IF[#1LT-5.4] X100
IF[#1GE-5.4] X5
IF[#1GE-5.3] X100
IF[[#1+1]LE[2*3]] X6
IF[#1LE-5.5] X100
M30
=== truth
rapid 1 0 0
rapid 2 0 0
rapid 3 0 0
rapid 4 0 0
rapid 5 0 0
rapid 6 0 0
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 1 0 0 t0.004
4: rapid to 2 0 0 t0.004
6: rapid to 3 0 0 t0.004
8: rapid to 4 0 0 t0.004
10: rapid to 5 0 0 t0.004
12: rapid to 6 0 0 t0.004
14: event end code="M30"
end of program: 14 blocks, 6 motions, 0 errors, 0 warnings
