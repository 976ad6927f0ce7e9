=== about
proves: nct-15.5.1-IJK nct-15.5.3-IJK nct-15.5.2-inner
=== settings
D1 = 10
H1 = 0
=== main
F500
N50 G41 G0 X100 Y0 I50 J86.60254 D1
N60 G1 X50 Y86.60254
N70 X-50
N80 X-100 Y0
N90 X-50 Y-86.60254
N100 X50
N110 X100 Y0
N120 G40 G0 X0 I-50 J86.60254
M30
=== truth
88.4530 0 0
44.2265 76.6025 0
-44.2265 76.6025 0
-88.4530 0 0
-44.2265 -76.6025 0
44.2265 -76.6025 0
88.4530 0 0
0 0 0
=== expect
file 0 main.nc
2 N50: rapid from 0 0 0 to 88.453 0 0 t0.3538
3 N60: feed to 44.2265 76.6025 0 F500 t10.6144
4 N70: feed to -44.2265 76.6025 0 F500 t10.6144
5 N80: feed to -88.453 0 0 F500 t10.6144
6 N90: feed to -44.2265 -76.6025 0 F500 t10.6144
7 N100: feed to 44.2265 -76.6025 0 F500 t10.6144
8 N110: feed to 88.453 0 0 F500 t10.6144
9 N120: rapid to 0 0 0 t0.3538
10: event end code="M30"
end of program: 10 blocks, 8 motions, 0 errors, 0 warnings
