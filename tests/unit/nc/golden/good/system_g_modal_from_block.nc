=== about
The same from each block; the block that activates it is the first.
proves: nct-23.3.4-Gmodal
=== settings
N1705 = -120
N1755.MEQ = 1
=== main
G120 Z-3
X1 Y0
X2 Y5
G67
X3
M30
=== sub SystemMacros/Channel1/O9011.nct
IF[#10EQ120] GOTO1
G90 G0 X[#24*10] Y[#25*10]
M99
N1 G0 Z#26
M99
=== truth
rapid 0 0 -3
rapid 10 0 -3
rapid 20 50 -3
rapid 3 50 -3
=== expect
file 0 main.nc
file 1 SystemMacros/Channel1/O9011.nct
1/4 N1 depth 1: rapid from 0 0 0 to 0 0 -3 t0.012
1/2 depth 1: rapid to 10 0 -3 t0.04
1/2 depth 1: rapid to 20 50 -3 t0.2
5: rapid to 3 50 -3 t0.068
6: event end code="M30"
end of program: 15 blocks, 4 motions, 0 errors, 0 warnings
