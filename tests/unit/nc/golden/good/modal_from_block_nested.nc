=== about
The last one activated takes the block first, its blocks are lists for the one before.
proves: nct-23.3.3-G66.1
=== main
G66.1 P1
G66.1 P2
X1
G67
X5
G67
G0 X9
M30
=== sub O0001
IF[#10EQ66.1] GOTO1
G90 G0 X[2*#24]
N1 M99
=== sub O0002
IF[#10EQ66.1] GOTO1
X[#24+0.5]
X[#24+1]
N1 M99
=== truth
rapid 3 0 0
rapid 4 0 0
rapid 10 0 0
rapid 9 0 0
=== expect
file 0 main.nc
file 1 O0001
file 2 O0002
1/2 depth 2: rapid from 0 0 0 to 3 0 0 t0.012
1/2 depth 2: rapid to 4 0 0 t0.004
1/2 depth 1: rapid to 10 0 0 t0.024
7: rapid to 9 0 0 t0.004
8: event end code="M30"
end of program: 25 blocks, 4 motions, 0 errors, 0 warnings
