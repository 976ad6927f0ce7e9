=== about
With N1337.CCA a centre word left out is the start's coordinate.
proves: nct-4.3-CCA
=== settings
N1337.CCA = 1
=== main
G0 X10 Y5 F100
G2 X0 Y15 I0
M30
=== truth
10 5 0
0 15 0 center 0 5 0 sweep -270
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 10 5 0 t0.04
2: feed arc to 0 15 0 center 0 5 0 normal 0 0 1 sweep -270 F100 t28.2743
3: event end code="M30"
end of program: 3 blocks, 2 motions, 0 errors, 0 warnings
