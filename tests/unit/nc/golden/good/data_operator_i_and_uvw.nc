=== about
proves: nct-5.1-G90 nct-5.1-G91 nct-5.1-I nct-5.1-UVW
=== main
F100
G90 G0 X60 Y20
G90 G01 X20 Y50
G0 X60 Y20
G91 G01 X-40 Y30
G90 G0 X60 Y20
G90 G01 XI-40 YI30
G0 X60 Y20
G01 X20 YI30
G0 X60 Y20
G01 XI-40 Y50
G0 X60 Y20
G90 G01 U-40 V30
G0 X60 Y20
G01 X20 V30
G0 X60 Y20
G01 U-40 Y50
M30
=== truth
60 20 0
20 50 0
60 20 0
20 50 0
60 20 0
20 50 0
60 20 0
20 50 0
60 20 0
20 50 0
60 20 0
20 50 0
60 20 0
20 50 0
60 20 0
20 50 0
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 60 20 0 t0.24
3: feed to 20 50 0 F100 t30
4: rapid to 60 20 0 t0.16
5: feed to 20 50 0 F100 t30
6: rapid to 60 20 0 t0.16
7: feed to 20 50 0 F100 t30
8: rapid to 60 20 0 t0.16
9: feed to 20 50 0 F100 t30
10: rapid to 60 20 0 t0.16
11: feed to 20 50 0 F100 t30
12: rapid to 60 20 0 t0.16
13: feed to 20 50 0 F100 t30
14: rapid to 60 20 0 t0.16
15: feed to 20 50 0 F100 t30
16: rapid to 60 20 0 t0.16
17: feed to 20 50 0 F100 t30
18: event end code="M30"
end of program: 18 blocks, 16 motions, 0 errors, 0 warnings
