=== about
The table of 23.1.6: a vacant value is no word, counts as 0 in arithmetic and compares as the greatest.
proves: nct-23.1.6-empty nct-23.1.6-const
=== main
G90 G0 X5 Y5
X20 Y#1 (Y is not there)
#2=7
#2=#1
X6 Y#2 Z-#2
#2=#1*3
Y#2
#2=#1+#1
X1 Z[#2+1]
IF[#1EQ#0] X2
IF[#1NE0] X3
IF[#1GE#0] X4
IF[#1GT0] X5
#1=0
IF[#1EQ#0] X99
IF[#1NE0] X99
IF[#1GE#0] X99
IF[#1GT0] X99
X20 Y#1
G#33 X21 M#32
X#3100 Y1
X[#_PI*10] Y[#_E*10] Z#_EMPTY
X[#3101] Y[#3102]
M30
=== truth
rapid 5 5 0
rapid 20 5 0
rapid 6 5 0
rapid 6 0 0
rapid 1 0 1
rapid 2 0 1
rapid 3 0 1
rapid 4 0 1
rapid 5 0 1
rapid 20 0 1
rapid 21 0 1
rapid 21 1 1
rapid 31.4159 27.1828 1
rapid 3.1416 2.7183 1
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 5 5 0 t0.02
2: rapid to 20 5 0 t0.06
5: rapid to 6 5 0 t0.056
7: rapid to 6 0 0 t0.02
9: rapid to 1 0 1 t0.02
10: rapid to 2 0 1 t0.004
11: rapid to 3 0 1 t0.004
12: rapid to 4 0 1 t0.004
13: rapid to 5 0 1 t0.004
19: rapid to 20 0 1 t0.06
20: rapid to 21 0 1 t0.004
21: rapid to 21 1 1 t0.004
22: rapid to 31.4159 27.1828 1 t0.1047
23: rapid to 3.1416 2.7183 1 t0.1131
24: event end code="M30"
end of program: 24 blocks, 14 motions, 0 errors, 0 warnings
