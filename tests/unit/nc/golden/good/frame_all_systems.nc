=== about
proves: nct-10.2.1-G57 nct-10.2.1-G58 nct-10.2.1-G59 nct-3-G57 nct-3-G58 nct-3-G59
=== settings
G57 = 40 0 0
G58 = 50 0 0
G59 = 60 0 0
=== main
G57 G0 X1
G58 X1
G59 X1
G54 X1
M30
=== truth
41 0 0
51 0 0
61 0 0
1 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 41 0 0 t0.164
2: rapid to 51 0 0 t0.04
3: rapid to 61 0 0 t0.04
4: rapid to 1 0 0 t0.24
5: event end code="M30"
end of program: 5 blocks, 4 motions, 0 errors, 0 warnings
