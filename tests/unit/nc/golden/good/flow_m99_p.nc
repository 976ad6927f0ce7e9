=== about
proves: nct-14.4.3-M99P nct-14.4.3-M99
=== main
N101 M98 P11
N102 G0 X102
N250 G0 X250
M30
=== sub O0011.nc
G90 G0 X7
M99 P250
=== truth
7 0 0
250 0 0
=== expect
file 0 main.nc
file 1 O0011.nc
1/1 depth 1: rapid from 0 0 0 to 7 0 0 t0.028
3 N250: rapid to 250 0 0 t0.972
4: event end code="M30"
end of program: 5 blocks, 2 motions, 0 errors, 0 warnings
