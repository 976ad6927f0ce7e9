=== about
The intermediate point of G28 is turned with the work system, the reference point is not. Without axes nothing moves. G10 L2 on the
system in force moves nothing, but the words behind it.
proves: nct-9.1-G28 nct-10.2.4-G10L2
=== settings
reference1 = 1 2 3
=== main
G0 X5
G10 L2 P1 X10
X5
G10 L2 P1 X0 I90
G28 X10 Y0
G28
G30 P2
M30
=== truth
5 0 0
15 0 0
0 10 0
1 2 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 5 0 0 t0.02
3: rapid to 15 0 0 t0.04
5: rapid to 0 10 0 t0.06
5: rapid to 1 2 0 t0.032
main.nc:6:1: warning[nct-2004]: no axis is named: no motion
    G28
    ^~~
main.nc:7:1: warning[nct-2004]: no axis is named: no motion
    G30 P2
    ^~~~~~
8: event end code="M30"
end of program: 8 blocks, 4 motions, 0 errors, 2 warnings
