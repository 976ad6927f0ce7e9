=== about
Loops one after the other, inside each other, jumped into and out of; a subprogram nests afresh.
proves: nct-23.2.11-DO nct-23.2.11-nesting
=== main
G0 G91
(one after the other)
DO1
X1
IF[#1EQ1] GOTO10
#1=1
END1
N10 Y1
(nested)
#1=0
WHILE[#1LT2] DO1
#1=#1+1
#2=0
WHILE[#2LT2] DO2
#2=#2+1
#3=0
WHILE[#3LT2] DO 3
#3=#3+1
X1
END3
Y1
END2
Z1
END1
(never entered)
WHILE[1EQ2] DO2
X100
END2
(into a loop from before and from behind)
#1=0
GOTO20
DO1
X100
N20 #1=#1+1
Y10
IF[#1EQ2] GOTO30
END1
N30 M98 P11
GOTO40
M30
DO2
X100
N40 Z10
GOTO50
END2
N50 M30
=== sub O0011
#5=0
WHILE[#5LT2] DO1
DO2
X1
GOTO1
END2
N1 #5=#5+1
END1
M99
=== truth
rapid 1 0 0
rapid 2 0 0
rapid 2 1 0
rapid 3 1 0
rapid 4 1 0
rapid 4 2 0
rapid 5 2 0
rapid 6 2 0
rapid 6 3 0
rapid 6 3 1
rapid 7 3 1
rapid 8 3 1
rapid 8 4 1
rapid 9 4 1
rapid 10 4 1
rapid 10 5 1
rapid 10 5 2
rapid 10 15 2
rapid 110 15 2
rapid 110 25 2
rapid 111 25 2
rapid 112 25 2
rapid 112 25 12
=== expect
file 0 main.nc
4: rapid from 0 0 0 to 1 0 0 t0.004
4: rapid to 2 0 0 t0.004
8 N10: rapid to 2 1 0 t0.004
19: rapid to 3 1 0 t0.004
19: rapid to 4 1 0 t0.004
21: rapid to 4 2 0 t0.004
19: rapid to 5 2 0 t0.004
19: rapid to 6 2 0 t0.004
21: rapid to 6 3 0 t0.004
23: rapid to 6 3 1 t0.004
19: rapid to 7 3 1 t0.004
19: rapid to 8 3 1 t0.004
21: rapid to 8 4 1 t0.004
19: rapid to 9 4 1 t0.004
19: rapid to 10 4 1 t0.004
21: rapid to 10 5 1 t0.004
23: rapid to 10 5 2 t0.004
35: rapid to 10 15 2 t0.04
33: rapid to 110 15 2 t0.4
35: rapid to 110 25 2 t0.04
file 1 O0011
1/4 depth 1: rapid to 111 25 2 t0.004
1/4 depth 1: rapid to 112 25 2 t0.004
43 N40: rapid to 112 25 12 t0.04
46 N50: event end code="M30"
end of program: 112 blocks, 23 motions, 0 errors, 0 warnings
