=== about
G40 under G0 with a step of zero: off the contour by feed, as the start goes onto it. A way along Z alone is none in the
plane; without a word of the plane, and with a way in it, G0 stays rapid.
proves: nct-15.5.1-zeromove
=== settings
D1 = 5
=== main
G54 G17 G0 X0 Y0 F500
G41 G0 G91 Y0 Z-5 D1
G90 G1 X50
G40 G0 G91 Y0
G90 X0 Y0
G41 X0 Y10
G1 Y50
G40 G0 Y60
X0 Y0
G41 G0
X20
G1 X40
G40 G0 X60
M30
=== truth
feed 0 5 -5 F 500
feed 50 5 -5 F 500
feed 50 0 -5 F 500
rapid 0 0 -5
rapid -5 10 -5
feed -5 50 -5 F 500
rapid 0 60 -5
rapid 0 0 -5
rapid 0 5 -5
rapid 20 5 -5
feed 40 5 -5 F 500
rapid 60 0 -5
=== expect
file 0 main.nc
2: feed from 0 0 0 to 0 5 -5 F500 t0.8485
3: feed to 50 5 -5 F500 t6
3: feed to 50 0 -5 F500 t0.6
5: rapid to 0 0 -5 t0.2
6: rapid to -5 10 -5 t0.04
7: feed to -5 50 -5 F500 t4.8
8: rapid to 0 60 -5 t0.04
9: rapid to 0 0 -5 t0.24
11: rapid to 0 5 -5 t0.02
11: rapid to 20 5 -5 t0.08
12: feed to 40 5 -5 F500 t2.4
13: rapid to 60 0 -5 t0.08
14: event end code="M30"
end of program: 14 blocks, 12 motions, 0 errors, 0 warnings
