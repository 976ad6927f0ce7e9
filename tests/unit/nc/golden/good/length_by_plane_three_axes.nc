=== about
N1416.PLN: G19 G43 X Y Z H3 moves three axes, the length acts on X alone.
proves: nct-15.3-PLN nct-15.3-G43
=== settings
N1416.ZAX = 0
N1416.PLN = 1
H3 = 30
=== main
G0 G19 G43 X1 Y2 Z3 H3
G18 Z4
Y5
M30
=== truth
31 2 3
31 2 4
31 5 4
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 31 2 3 t0.124
2: rapid to 31 2 4 t0.004
3: rapid to 31 5 4 t0.012
4: event end code="M30"
end of program: 4 blocks, 3 motions, 0 errors, 0 warnings
