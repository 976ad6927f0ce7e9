=== about
Windows and times of the position check have no effect on an ideal machine, which is always in position (2501 never
comes). Nobody turns the override switches: all speeds are those of the program.
proves: nct-4.1.1-N0516 nct-4.1.1-N1340 nct-4.1.1-2501 nct-6.1-override nct-6.2-override
=== settings
N0516.1 = 0.02
N1340 = 3
=== main
G61 G0 X10
G1 X20 F600
M30
=== truth
rapid 10 0 0 t 0.04
feed 20 0 0 F 600 t 1
=== expect
note[nct-noted]: parameter N0516 has no effect in the simulation
note[nct-noted]: parameter N1340 has no effect in the simulation
file 0 main.nc
1: rapid from 0 0 0 to 10 0 0 t0.04
2: feed to 20 0 0 F600 t1
3: event end code="M30"
end of program: 3 blocks, 2 motions, 0 errors, 0 warnings
