=== about
158.3478 mm at F150: 63.339 s.
proves: nct-4.3.2-HEF nct-4.3.2-helix
=== settings
N1337.HEF = 1
=== main
G17 G90 G0 X100 Y0 Z0
G03 X0 Y100 Z20 R100 F150
M30
=== truth
100 0 0
0 100 20 center 0 0 0 sweep 90 t 63.3391
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 100 0 0 t0.4
2: feed arc to 0 100 20 center 0 0 0 normal 0 0 1 sweep 90 F150 t63.3391
3: event end code="M30"
end of program: 3 blocks, 2 motions, 0 errors, 0 warnings
