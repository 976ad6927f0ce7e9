=== about
proves: nct-14.4.3-M99L
=== main
M98 P11 L20
M30
=== sub O0011.nc
G91 G0 X1
M99 L0
=== truth
1 0 0
=== expect
file 0 main.nc
file 1 O0011.nc
1/1 depth 1: rapid from 0 0 0 to 1 0 0 t0.004
2: event end code="M30"
end of program: 4 blocks, 1 motions, 0 errors, 0 warnings
