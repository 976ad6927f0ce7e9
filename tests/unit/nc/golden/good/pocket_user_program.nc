=== about
A program of the user goes before the built-in one.
proves: nct-23.6-P9999
=== main
G65 P9999 X60
M30
=== sub O9999
G0 X#24
M99
=== truth
rapid 60 0 0
=== expect
file 0 main.nc
file 1 O9999
1/1 depth 1: rapid from 0 0 0 to 60 0 0 t0.24
2: event end code="M30"
end of program: 4 blocks, 1 motions, 0 errors, 0 warnings
