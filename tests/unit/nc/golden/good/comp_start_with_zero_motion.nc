=== about
G42 with a step of zero: the way of the tool's radius, square to the next block, is made by feed, under G0 too, and belongs to that block. G40 with a step of zero returns to
the contour.
proves: nct-15.5.1-zeromove
=== settings
D1 = 5
=== main
N10 G54 G17 G49 M3 S500
N20 G0 X-40 Y-40
N40 G1 Z-5 F500
N50 G42 G0 G91 X0 D1
N60 G90 X0 Y0
N70 G1 X60
N80 Y60
N90 X0
N100 Y0
N110 G40 G91 Y0
N120 G0 G90 X-40 Y-40
M30
=== truth
-40 -40 0
-40 -40 -5
feed -36.4645 -43.5355 -5 F 500
rapid 2.0711 -5 -5
65 -5 -5
65 65 -5
-5 65 -5
-5 0 -5
0 0 -5
-40 -40 -5
=== expect
file 0 main.nc
1 N10: event spindle rpm=500 direction="cw"
2 N20: rapid from 0 0 0 to -40 -40 0 t0.16
3 N40: feed to -40 -40 -5 F500 t0.6
4 N50: feed to -36.4645 -43.5355 -5 F500 t0.6
5 N60: rapid to 2.0711 -5 -5 t0.1541
6 N70: feed to 65 -5 -5 F500 t7.5515
7 N80: feed to 65 65 -5 F500 t8.4
8 N90: feed to -5 65 -5 F500 t8.4
9 N100: feed to -5 0 -5 F500 t7.8
9 N100: feed to 0 0 -5 F500 t0.6
11 N120: rapid to -40 -40 -5 t0.16
12: event end code="M30"
end of program: 12 blocks, 10 motions, 0 errors, 0 warnings
