=== about
Single block inside system programs does not exist here.
proves: nct-23.3.9-list
=== settings
N1704 = 101
N1756.MD8 = 1
N1756.MD9 = 1
=== main
G101 A1
M30
=== sub SystemMacros/Channel1/O9010.nct
G0 X#1
M99
=== truth
rapid 1 0 0
=== expect
note[nct-noted]: parameter N1756.MD8 has no effect in the simulation
note[nct-noted]: parameter N1756.MD9 has no effect in the simulation
file 0 main.nc
file 1 SystemMacros/Channel1/O9010.nct
1/1 depth 1: rapid from 0 0 0 to 1 0 0 t0.004
2: event end code="M30"
end of program: 4 blocks, 1 motions, 0 errors, 0 warnings
