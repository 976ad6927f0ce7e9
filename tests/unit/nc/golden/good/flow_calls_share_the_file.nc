=== about
proves: nct-14.4.2-M98P
=== main
M98 P11
M98 P11
M30
=== sub O0011.nc
G91 G0 X1
M99
=== truth
1 0 0
2 0 0
=== expect
file 0 main.nc
file 1 O0011.nc
1/1 depth 1: rapid from 0 0 0 to 1 0 0 t0.004
1/1 depth 1: rapid to 2 0 0 t0.004
3: event end code="M30"
end of program: 7 blocks, 2 motions, 0 errors, 0 warnings
