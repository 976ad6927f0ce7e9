=== about
N1416 with ZAX and PLN: as with ZAX alone. #5083 tells the length with the sign of G44.
proves: nct-15.3-ZAX nct-15.3-G44
=== settings
N1416.ZAX = 1
N1416.PLN = 1
H1 = 7
=== main
G0 G19 G43 X0 Y0 Z0 H1
G44 Z0
#100=#5083
X#100
M30
=== truth
0 0 7
0 0 -7
-7 0 -7
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 7 t0.028
2: rapid to 0 0 -7 t0.056
4: rapid to -7 0 -7 t0.028
5: event end code="M30"
end of program: 5 blocks, 3 motions, 0 errors, 0 warnings
