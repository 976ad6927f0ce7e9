=== about
proves: nct-3-G68 nct-3-G69 nct-16.1-G68 nct-16.1-G69
=== main
N1 G17 G90 G0 X0 Y0
N2 G68 X90 Y60 R80
N3 G1 X60 Y20 F150
N4 X140
N5 G3 Y80 R50
N6 G1 X60
N7 Y20
N8 G69 G0 X0 Y0
M30
=== truth
124.1829 23.5098 0 feed
138.0747 102.2945 0
78.9863 112.7134 0 center 101.5846 68.1116 0
65.0944 33.9287 0
124.1829 23.5098 0
0 0 0 rapid
=== expect
file 0 main.nc
3 N3: feed from 0 0 0 to 124.1829 23.5098 0 F150 t50.5555
4 N4: feed to 138.0747 102.2945 0 F150 t32
5 N5: feed arc to 78.9863 112.7134 0 center 101.5846 68.1116 0 normal 0 0 1 sweep 73.7398 F150 t25.74
6 N6: feed to 65.0944 33.9287 0 F150 t32
7 N7: feed to 124.1829 23.5098 0 F150 t24
8 N8: rapid to 0 0 0 t0.4967
9: event end code="M30"
end of program: 9 blocks, 6 motions, 0 errors, 0 warnings
