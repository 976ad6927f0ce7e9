=== about
One quarter in the three planes: K belongs to the first axis of G18.
proves: nct-4.3-IJK nct-3-G17 nct-3-G18 nct-3-G19
=== main
F200
G17 G0 X80 Y40 Z0
G3 X10 Y70 I-50 J-20
G18 G0 X40 Y0 Z80
G3 X70 Z10 I-20 K-50
G19 G0 X0 Y80 Z40
G3 Y10 Z70 J-50 K-20
M30
=== truth
80 40 0
10 70 0 center 30 20 0 sweep 90
40 0 80
70 0 10 center 20 0 30 sweep 90
0 80 40
0 10 70 center 0 30 20 sweep 90
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 80 40 0 t0.32
3: feed arc to 10 70 0 center 30 20 0 normal 0 0 1 sweep 90 F200 t25.377
4: rapid to 40 0 80 t0.32
5: feed arc to 70 0 10 center 20 0 30 normal 0 1 0 sweep 90 F200 t25.377
6: rapid to 0 80 40 t0.32
7: feed arc to 0 10 70 center 0 30 20 normal 1 0 0 sweep 90 F200 t25.377
8: event end code="M30"
end of program: 8 blocks, 6 motions, 0 errors, 0 warnings
