=== about
proves: nct-4.3-G3
=== main
G0 X10 Y0 F100
G3 I-10
F200 M8
G3
M30
=== truth
10 0 0
10 0 0 sweep 360
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 10 0 0 t0.04
2: feed arc to 10 0 0 center 0 0 0 normal 0 0 1 sweep 360 F100 t37.6991
3: event coolant code="M8" on=true
5: event end code="M30"
end of program: 5 blocks, 2 motions, 0 errors, 0 warnings
