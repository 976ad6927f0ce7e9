=== about
H acts from the approach on.
proves: nct-18.2-G43 nct-18.1.5-G81
=== settings
H1 = 10
=== main
G0 Z50
G43 H1 G99 G81 X5 Z-10 R2 F100
M30
=== truth
0 0 50
5 0 50
5 0 12
5 0 0
5 0 12
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 50 t0.2
2: rapid to 5 0 50 t0.02
2: rapid to 5 0 12 t0.152
2: feed to 5 0 0 F100 t7.2
2: rapid to 5 0 12 t0.048
3: event end code="M30"
end of program: 3 blocks, 5 motions, 0 errors, 0 warnings
