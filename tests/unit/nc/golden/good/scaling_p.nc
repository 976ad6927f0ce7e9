=== about
proves: nct-3-G50 nct-3-G51 nct-16.2-G51-P nct-16.2-G50
=== main
N1 G17 G90 G0 X0 Y0
N2 G51 X90 Y60 P0.6
N3 G1 X60 Y20 F150
N4 X140
N5 G3 Y80 R50
N6 G1 X60
N7 Y20
N8 G50 G0 X0 Y0
M30
=== truth
72 36 0
120 36 0
120 72 0 center 96 54 0
72 72 0
72 36 0
0 0 0
=== expect
file 0 main.nc
3 N3: feed from 0 0 0 to 72 36 0 F150 t32.1994
4 N4: feed to 120 36 0 F150 t19.2
5 N5: feed arc to 120 72 0 center 96 54 0 normal 0 0 1 sweep 73.7398 F150 t15.444
6 N6: feed to 72 72 0 F150 t19.2
7 N7: feed to 72 36 0 F150 t14.4
8 N8: rapid to 0 0 0 t0.288
9: event end code="M30"
end of program: 9 blocks, 6 motions, 0 errors, 0 warnings
