=== about
proves: nct-3-G18 nct-3-G17
=== main
G0 X40 Y0 Z80 F100
G18 G3 X70 Z10 I-20 K-50
G17 G2 X60 Y-10 I-10 J0
M30
=== truth
40 0 80
70 0 10 center 20 0 30 sweep 90
60 -10 10 center 60 0 10 sweep -90
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 40 0 80 t0.32
2: feed arc to 70 0 10 center 20 0 30 normal 0 1 0 sweep 90 F100 t50.754
3: feed arc to 60 -10 10 center 60 0 10 normal 0 0 1 sweep -90 F100 t9.4248
4: event end code="M30"
end of program: 4 blocks, 3 motions, 0 errors, 0 warnings
