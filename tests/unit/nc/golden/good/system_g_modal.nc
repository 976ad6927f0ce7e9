=== about
A negative parameter makes the code modal, after each motion.
proves: nct-23.3.4-Gmodal
=== settings
N1705 = -120
=== main
G120 Z-3
G0 X1
X2
G67
X3
M30
=== sub SystemMacros/Channel1/O9011.nct
G90 G0 Z#26
M99
=== truth
rapid 1 0 0
rapid 1 0 -3
rapid 2 0 -3
rapid 3 0 -3
=== expect
file 0 main.nc
file 1 SystemMacros/Channel1/O9011.nct
2: rapid from 0 0 0 to 1 0 0 t0.004
1/1 depth 1: rapid to 1 0 -3 t0.012
3: rapid to 2 0 -3 t0.004
5: rapid to 3 0 -3 t0.004
6: event end code="M30"
end of program: 10 blocks, 4 motions, 0 errors, 0 warnings
