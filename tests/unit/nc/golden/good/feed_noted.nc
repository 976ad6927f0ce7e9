=== about
Windows and times of the position check have no effect on an ideal machine.
proves: nct-4.1.1-N0516 nct-4.1.1-N1340
=== settings
N0516.1 = 0.02
N1340 = 3
=== main
G61 G0 X10
M30
=== truth
10 0 0
=== expect
note[nct-noted]: parameter N0516 has no effect in the simulation
note[nct-noted]: parameter N1340 has no effect in the simulation
file 0 main.nc
1: rapid from 0 0 0 to 10 0 0 t0.04
2: event end code="M30"
end of program: 2 blocks, 1 motions, 0 errors, 0 warnings
