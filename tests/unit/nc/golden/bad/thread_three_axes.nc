=== about
A thread moves two axes at most, and no cutter compensation runs with it.
=== settings
max_errors = 5
D1 = 2
=== main
S100 M3
G33 X1 Y1 Z-10 F2
G0 X0 Y0
G41 D1 X10
G33 Z-10 F2
M30
=== says
main.nc:2:1: error[nct-2017]
main.nc:5:1: error[nct-thread-comp]
=== expect
file 0 main.nc
1: event spindle rpm=100 direction="cw"
main.nc:2:1: error[nct-2017]: illegal address: G33 moves one axis or two
    G33 X1 Y1 Z-10 F2
    ^~~~~~~~~~~~~~~~~
main.nc:5:1: error[nct-thread-comp]: G33 cannot run with cutter compensation: program G40 first
    G33 Z-10 F2
    ^~~~~~~~~~~
4: rapid from 0 0 0 to 10 0 0 t0.04
6: event end code="M30"
end of program: 6 blocks, 1 motions, 2 errors, 0 warnings
