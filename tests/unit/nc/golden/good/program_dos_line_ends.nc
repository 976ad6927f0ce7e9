=== about
proves: nct-1.1-word
=== main
G0 X1
Y2
M30
=== truth
1 0 0
1 2 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 0 t0.004
2: rapid to 1 2 0 t0.008
3: event end code="M30"
end of program: 3 blocks, 2 motions, 0 errors, 0 warnings
