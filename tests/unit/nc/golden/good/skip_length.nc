=== about
Tool of length 100: the tip touches at Z-5. #5063 holds the length offset, #151103 is the same in machine coordinates. The
feed is that of N0311.
proves: nct-21.1-G31
=== settings
H1 = 100
G54 = 10 20 30
probe = plane 0 0 -1 -95
N3001.SKF = 1
N0311 = 75
=== main
G43 G0 Z50 H1
G31 Z-40
#100=#5063
#101=#5003
#102=#5083
#103=#151103-#5063
G0 X#100 Y#101 Z#102
X#103
M30
=== truth
0 0 150
probe 0 0 95 F 75
95 -5 200
30 -5 200
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 150 t0.6
2: probe to 0 0 95 F75 t44
2: event probe contact=true
7: rapid to 95 -5 200 t0.42
8: rapid to 30 -5 200 t0.26
9: event end code="M30"
end of program: 9 blocks, 4 motions, 0 errors, 0 warnings
