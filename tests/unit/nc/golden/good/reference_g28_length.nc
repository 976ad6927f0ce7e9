=== about
Leg 1 does not move; afterwards the program reads Z200.
proves: nct-9.1-G28
=== settings
G54 = 0 0 -300
H1 = 100
reference1 = 0 0 0
=== main
G0 Z150
G43 Z50 H1
G91 G28 Z0
G90 Z200
Z199
M30
=== truth
0 0 150
0 0 300
0 0 299
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 150 t0.6
3: rapid to 0 0 300 t0.6
5: rapid to 0 0 299 t0.004
6: event end code="M30"
end of program: 6 blocks, 3 motions, 0 errors, 0 warnings
