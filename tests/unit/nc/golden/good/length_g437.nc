=== about
Turning lengths on a mill: all three axes at once, whatever N1416 and N1414 say; H changes them; a changed row
acts when H comes again; G43 and G44 go back to the milling length, G49 deletes.
proves: nct-3-G43.7 nct-15.4-G43.7 nct-15.4-G49 nct-15.4-back nct-15.4-N1414 nct-15.1-table-turn
nct-15.2-G10-L200 nct-15.2-G10-L201
=== settings
N1416.ZAX = 0
N1416.PLN = 1
N1414 = 7
=== main
G10 L201 P5 X50 Y-3 Z120 R0.8 Q3
G10 L200 P5 X-0.2 Y0.1 Z0.5
G10 L201 P6 X40 Y0 Z100
G43.7 H5
G0 X0 Y0 Z0
G91 G10 L201 P5 X1
G90 X10
H5
Y10
H6 Z1
G19 G43 X0 Y0 Z0 H5
G17 G44 Z0
G43.7 H6 X0 Y0 Z0
G49 X1 Y2 Z3
M30
=== truth
49.8 -2.9 120.5
59.8 * *
59.8 7.1 *
59.8 7.1 101
120.5 0 0
120.5 0 -120.5
40 0 100
1 2 3
=== expect
note[nct-noted]: parameter N1414 has no effect in the simulation
file 0 main.nc
5: rapid from 0 0 0 to 49.8 -2.9 120.5 t0.482
7: rapid to 59.8 -2.9 120.5 t0.04
9: rapid to 59.8 7.1 120.5 t0.04
10: rapid to 59.8 7.1 101 t0.078
11: rapid to 120.5 0 0 t0.404
12: rapid to 120.5 0 -120.5 t0.482
13: rapid to 40 0 100 t0.882
14: rapid to 1 2 3 t0.388
15: event end code="M30"
end of program: 15 blocks, 8 motions, 0 errors, 0 warnings
