=== about
M99 in a block with a motion waits for the modal macro.
proves: nct-23.3.2-G66
=== main
G66 P2
G0
M98 P11
X100
G67
M30
=== sub O0002
G91 Z1
G90
M99
=== sub O0011
X5 M99
X77
=== truth
rapid 5 0 0
rapid 5 0 1
rapid 100 0 1
rapid 100 0 2
=== expect
file 0 main.nc
file 1 O0002
file 2 O0011
2/1 depth 1: rapid from 0 0 0 to 5 0 0 t0.02
1/1 depth 2: rapid to 5 0 1 t0.004
4: rapid to 100 0 1 t0.38
1/1 depth 1: rapid to 100 0 2 t0.004
6: event end code="M30"
end of program: 13 blocks, 4 motions, 0 errors, 0 warnings
