=== about
The machine moves by the increment only.
proves: nct-15.3-INC
=== settings
H2 = 20
=== main
G43 G0 G91 Z0 H2
Z5
G90 Z0
M30
=== truth
0 0 5
0 0 20
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 0 0 5 t0.02
3: rapid to 0 0 20 t0.06
4: event end code="M30"
end of program: 4 blocks, 2 motions, 0 errors, 0 warnings
