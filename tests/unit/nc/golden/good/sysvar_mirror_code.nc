=== about
#4022 is 151 in G51.1 and 150 in G50.1.
proves: nct-23.1.14-#4001
=== main
G0 G51.1 Z0
#100=#4022
G50.1 Z0
X#100 Y#4022
M30
=== truth
151 150 0
=== expect
file 0 main.nc
4: rapid from 0 0 0 to 151 150 0 t0.604
5: event end code="M30"
end of program: 5 blocks, 1 motions, 0 errors, 0 warnings
