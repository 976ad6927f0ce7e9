=== about
proves: nct-15.3-PLN nct-15.3-G43
=== settings
H2 = 20
H3 = 30
N1416.ZAX = 0
N1416.PLN = 1
=== main
G0 G17 G43 H2
G19 H3
X0 Z0
M30
=== truth
30 0 20
=== expect
file 0 main.nc
3: rapid from 0 0 0 to 30 0 20 t0.12
4: event end code="M30"
end of program: 4 blocks, 1 motions, 0 errors, 0 warnings
