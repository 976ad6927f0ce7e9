=== about
Nothing stands between blocks that are tangent.
proves: nct-17.1-R
=== main
G17 G1 X10 ,R3 F100
X20 ,C2
G3 X30 Y10 R10
M30
=== truth
10 0 0
20 0 0
30 10 0
=== expect
file 0 main.nc
1: feed from 0 0 0 to 10 0 0 F100 t6
2: feed to 20 0 0 F100 t6
3: feed arc to 30 10 0 center 20 10 0 normal 0 0 1 sweep 90 F100 t9.4248
4: event end code="M30"
end of program: 4 blocks, 3 motions, 0 errors, 0 warnings
