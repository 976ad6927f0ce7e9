=== about
proves: nct-14.4.2-M98P
=== main
M98 P11
G0 X2
M30
=== sub O0011.nc
G0 X1
=== truth
1 0 0
2 0 0
=== expect
file 0 main.nc
file 1 O0011.nc
1/1 depth 1: rapid from 0 0 0 to 1 0 0 t0.004
O0011.nc:1:1: warning[nct-no-m99]: the subprogram ends without M99: taken as M99
    G0 X1
    ^~~~~
    note: called from main.nc:1 by M98
2: rapid to 2 0 0 t0.004
3: event end code="M30"
end of program: 4 blocks, 2 motions, 0 errors, 1 warnings
