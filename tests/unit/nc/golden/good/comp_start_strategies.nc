=== about
G41 from G40 in front of an outer obtuse corner (120 degrees), an outer acute one (45) and an inner one (270).
proves: nct-15.5.1-G41 nct-3-G41 nct-15.5.3-noaxis
=== settings
D1 = 10
=== main
G0 X-50
G41 G1 X0 D1 F1000
X30 Y-51.9615
G40
G0 X-50 Y0
G41 G1 X0
X-30 Y-30
G40
G0 X-50 Y0
G41 G1 X0
Y40
G40
M30
=== truth
rapid -50 0 0
feed 5.7735 10 0
feed 38.6603 -46.9615 0
feed 30 -51.9615 0
rapid -50 0 0
feed 10 10 0
feed 14.1421 0 0
feed -22.9289 -37.0711 0
feed -30 -30 0
rapid -50 0 0
feed -10 0 0
feed -10 40 0
feed 0 40 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -50 0 0 t0.2
2: feed to 5.7735 10 0 F1000 t3.3998
3: feed to 38.6603 -46.9615 0 F1000 t3.9464
3: feed to 30 -51.9615 0 F1000 t0.6
5: rapid to -50 0 0 t0.32
6: feed to 10 10 0 F1000 t3.6497
6: feed to 14.1421 0 0 F1000 t0.6494
7: feed to -22.9289 -37.0711 0 F1000 t3.1456
7: feed to -30 -30 0 F1000 t0.6
9: rapid to -50 0 0 t0.12
10: feed to -10 0 0 F1000 t2.4
11: feed to -10 40 0 F1000 t2.4
11: feed to 0 40 0 F1000 t0.6
13: event end code="M30"
end of program: 13 blocks, 13 motions, 0 errors, 0 warnings
