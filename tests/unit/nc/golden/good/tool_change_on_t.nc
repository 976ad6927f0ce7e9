=== about
A change by hand is prompted on the machine and goes on with START; here it only takes its time.
proves: nct-12.1-T nct-12.2-manual
=== settings
N1338.M06 = 0
=== main
T0003
G0 X1
M30
=== truth
1 0 0
=== expect
file 0 main.nc
1: event tool tool=3
2: rapid from 0 0 0 to 1 0 0 t0.004
3: event end code="M30"
end of program: 3 blocks, 1 motions, 0 errors, 0 warnings
