=== about
Optional skip of blocks by nine switches; / alone is /1, the sign stands in front of N.
proves: nct-1.1-skip
=== settings
skip = 2
skip = 9
=== main
/ G0 X1
/1 N10 X2
/2 N20 X3
/3 N30 Y3
/4 Y4
/5 Y5
/6 Y6
/7 Y7
/8 Y8
/9 Y9
X4
M30
=== truth
1 0 0
2 0 0
2 3 0
2 4 0
2 5 0
2 6 0
2 7 0
2 8 0
4 8 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 0 t0.004
2 N10: rapid to 2 0 0 t0.004
4 N30: rapid to 2 3 0 t0.012
5: rapid to 2 4 0 t0.004
6: rapid to 2 5 0 t0.004
7: rapid to 2 6 0 t0.004
8: rapid to 2 7 0 t0.004
9: rapid to 2 8 0 t0.004
11: rapid to 4 8 0 t0.008
12: event end code="M30"
end of program: 10 blocks, 9 motions, 0 errors, 0 warnings
