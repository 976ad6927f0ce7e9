=== about
ZAX = PLN = 0: H without an axis word changes only the modal H.
proves: nct-15.3-AXES nct-15.3-G43 nct-15.1-H nct-15.3-H-modal
=== settings
H1 = 10
H2 = 20
N1416.ZAX = 0
=== main
G0 G43 Z100 H1
Z100 H2
Z100 H0
Z100 H2
H0
Z100
M30
=== truth
0 0 110
0 0 120
0 0 100
0 0 120
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 110 t0.44
2: rapid to 0 0 120 t0.04
3: rapid to 0 0 100 t0.08
4: rapid to 0 0 120 t0.08
7: event end code="M30"
end of program: 7 blocks, 4 motions, 0 errors, 0 warnings
