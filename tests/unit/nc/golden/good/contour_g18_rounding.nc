=== about
proves: nct-17.1-R
=== main
G18 G1 X30 ,R10 F100
Z-30
M30
=== truth
20 0 0
30 0 -10 center 20 0 -10
30 0 -30
=== expect
file 0 main.nc
1: feed from 0 0 0 to 20 0 0 F100 t12
1: feed arc to 30 0 -10 center 20 0 -10 normal 0 1 0 sweep 90 F100 t9.4248
2: feed to 30 0 -30 F100 t12
3: event end code="M30"
end of program: 3 blocks, 3 motions, 0 errors, 0 warnings
