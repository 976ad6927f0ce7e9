=== about
proves: nct-14.4.2-M98P
=== main
M98 P12345
M30
=== sub O00012345.nc
G0 X1
M99
=== truth
1 0 0
=== expect
file 0 main.nc
file 1 O00012345.nc
1/1 depth 1: rapid from 0 0 0 to 1 0 0 t0.004
2: event end code="M30"
end of program: 4 blocks, 1 motions, 0 errors, 0 warnings
