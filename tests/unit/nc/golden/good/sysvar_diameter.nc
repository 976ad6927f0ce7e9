=== about
Positions, zero points and lengths of an axis in diameter are told and written as diameters.
proves: nct-5.3-DIA nct-23.1.15-absio nct-23.1.19-#5221
=== settings
N0106.DIA.1 = 1
N1416.ZAX = 0
H1 = 30
=== main
#5221=20
G0 X100
#100=#5001
#101=#5021
#102=#_WZG54[1]
G43 X100 H1
#103=#5081
#104=#_ABSOT[1]
G49 X0
Y#100 Z#101
Y#102 Z#103
Y#104
M30
=== truth
60 0 0
75 0 0
10 0 0
10 100 120
10 20 30
10 130 30
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 60 0 0 t0.24
6: rapid to 75 0 0 t0.06
9: rapid to 10 0 0 t0.26
10: rapid to 10 100 120 t0.48
11: rapid to 10 20 30 t0.36
12: rapid to 10 130 30 t0.44
13: event end code="M30"
end of program: 13 blocks, 6 motions, 0 errors, 0 warnings
