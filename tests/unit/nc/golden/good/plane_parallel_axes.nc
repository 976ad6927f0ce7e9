=== about
Planes of parallel axes by the words beside G17, G18, G19; without such a code the plane stays. Arcs in them move the
tool in the directions of X, Y, Z; a rotary word beside both linear axes changes nothing; a
main axis beside its parallel one stays that of the plane.
proves: nct-2.1-N0103 nct-2.1-names nct-10.4-G17 nct-10.4-G18 nct-10.4-G19 nct-3-G17 nct-3-G18 nct-3-G19 nct-1.1-XYZUVW
=== settings
axis = U 4 linear parallel X
axis = V 5 linear parallel Y
axis = W 6 linear parallel Z
axis = C 7 rotary
=== main
G1 F1000
G17 X10 V0
G3 X0 V10 I-10
G17 G1 U0 V10
G3 U-10 V0 J-10
G17 G1 U-20 Y5
G2 U-15 Y0 R5
G18 G1 W0 X0
G2 W10 X10 I10
G18 G1 Z0 X10
G3 Z10 X0 K10 I0
G19 G1 V0 Z10
G3 V10 Z20 J0 K10
G17 G1 X0 Y0 C0
G3 X10 Y10 R10
G17 G1 X10 Y10 U-15
G2 X20 Y0 R10
M30
=== truth
feed 10 0 0
feed 0 10 0 center 0 0 0 sweep 90
feed -10 0 0 center 0 0 0 sweep 90
feed -20 5 0
feed -15 0 0 center -20 0 0 sweep -90
feed -5 0 10 center -5 0 0 sweep -270
feed -15 0 20 center -5 0 20 sweep 90
feed -15 10 30 center -15 0 30 sweep 90
feed -5 20 30 center -15 20 30 sweep 90
feed 5 10 30 center -5 10 30 sweep -90
=== expect
file 0 main.nc
2: feed from 0 0 0 to 10 0 0 C 0 to 0 F1000 t0.6
3: feed arc to 0 10 0 center 0 0 0 normal 0 0 1 sweep 90 C 0 to 0 F1000 t0.9425
5: feed arc to -10 0 0 center 0 0 0 normal 0 0 1 sweep 90 C 0 to 0 F1000 t0.9425
6: feed to -20 5 0 C 0 to 0 F1000 t0.6708
7: feed arc to -15 0 0 center -20 0 0 normal 0 0 1 sweep -90 C 0 to 0 F1000 t0.4712
9: feed arc to -5 0 10 center -5 0 0 normal 0 1 0 sweep -270 C 0 to 0 F1000 t2.8274
11: feed arc to -15 0 20 center -5 0 20 normal 0 1 0 sweep 90 C 0 to 0 F1000 t0.9425
13: feed arc to -15 10 30 center -15 0 30 normal 1 0 0 sweep 90 C 0 to 0 F1000 t0.9425
15: feed arc to -5 20 30 center -15 20 30 normal 0 0 1 sweep 90 C 0 to 0 F1000 t0.9425
17: feed arc to 5 10 30 center -5 10 30 normal 0 0 1 sweep -90 C 0 to 0 F1000 t0.9425
18: event end code="M30"
end of program: 18 blocks, 10 motions, 0 errors, 0 warnings
