=== about
The plane of the arc turns with the work system; its normal is +X.
proves: nct-10.2.4-G10L2
=== main
G10 L2 P1 J90
G0 X10 Y0 F100
G3 X0 Y10 I-10
M30
=== truth
0 0 -10
0 10 0 center 0 0 0 sweep 90
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 0 0 -10 t0.04
3: feed arc to 0 10 0 center 0 0 0 normal 1 0 0 sweep 90 F100 t9.4248
4: event end code="M30"
end of program: 4 blocks, 2 motions, 0 errors, 0 warnings
