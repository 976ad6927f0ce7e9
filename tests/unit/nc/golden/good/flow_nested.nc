=== about
proves: nct-14.4.3-M99 nct-14.4.2-nesting nct-1.1-subprog
=== main
O0001
M98 P11
G0 Y1
M02
=== sub O0011.nc
G0 X1
M98 P12
Z1
M99
=== sub O0012.nc
X2
M98 P13
Z2
M99
=== sub O0013.nc
X3
M98 P14
Z3
M99
=== sub O0014.nc
X4
M99
=== truth
1 0 0
2 0 0
3 0 0
4 0 0
4 0 3
4 0 2
4 0 1
4 1 1
=== expect
file 0 main.nc
file 1 O0011.nc
1/1 depth 1: rapid from 0 0 0 to 1 0 0 t0.004
file 2 O0012.nc
2/1 depth 2: rapid to 2 0 0 t0.004
file 3 O0013.nc
3/1 depth 3: rapid to 3 0 0 t0.004
file 4 O0014.nc
4/1 depth 4: rapid to 4 0 0 t0.004
3/3 depth 3: rapid to 4 0 3 t0.012
2/3 depth 2: rapid to 4 0 2 t0.004
1/3 depth 1: rapid to 4 0 1 t0.004
3: rapid to 4 1 1 t0.004
4: event end code="M2"
end of program: 17 blocks, 8 motions, 0 errors, 0 warnings
