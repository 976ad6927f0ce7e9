=== about
Inside arcs of a compensated path: the feed holds at the contour (manual 6.4). R20 with a tool of 5 inside: 375.
Outside arcs keep it; N1406 is the least part: here 0.8.
proves: nct-6.4-inside-arc
=== settings
D1 = 5
=== main
G17 G0 X20 Y0
G41 D1 G1 X40 Y20 F500
G3 X20 Y40 R20
G40 G1 X20 Y20
G0 X80 Y20
G42 D1 G1 X60 Y20
G3 X40 Y40 R20
G1 X30
G40 X20 Y60
G10 L52
N1406 R0.8
G11
G0 X20 Y0
G41 D1 G1 X40 Y20
G3 X20 Y40 R20
G40 G1 X20 Y20
M30
=== truth
rapid 20 0 0
feed 35 20 0 F 500
feed 20 35 0 sweep 90 F 375
feed 20 20 0 F 500
rapid 80 20 0
feed 65 20 0 F 500
feed 40 45 0 sweep 90 F 500
feed 30 45 0 F 500
feed 20 60 0 F 500
rapid 20 0 0
feed 35 20 0 F 500
feed 20 35 0 sweep 90 F 400
feed 20 20 0 F 500
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 20 0 0 t0.08
2: feed to 35 20 0 F500 t3
3: feed arc to 20 35 0 center 20 20 0 normal 0 0 1 sweep 90 F375 t3.7699
4: feed to 20 20 0 F500 t1.8
5: rapid to 80 20 0 t0.24
6: feed to 65 20 0 F500 t1.8
7: feed arc to 40 45 0 center 40 20 0 normal 0 0 1 sweep 90 F500 t4.7124
8: feed to 30 45 0 F500 t1.2
9: feed to 20 60 0 F500 t2.1633
13: rapid to 20 0 0 t0.24
14: feed to 35 20 0 F500 t3
15: feed arc to 20 35 0 center 20 20 0 normal 0 0 1 sweep 90 F400 t3.5343
16: feed to 20 20 0 F500 t1.8
17: event end code="M30"
end of program: 17 blocks, 13 motions, 0 errors, 0 warnings
