=== about
The motion comes first, then the call.
proves: nct-14.4.2-M98P
=== main
G0 X5 M98 P11
M30
=== sub O0011.nc
Y7
M99
=== truth
5 0 0
5 7 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 5 0 0 t0.02
file 1 O0011.nc
1/1 depth 1: rapid to 5 7 0 t0.028
2: event end code="M30"
end of program: 4 blocks, 2 motions, 0 errors, 0 warnings
