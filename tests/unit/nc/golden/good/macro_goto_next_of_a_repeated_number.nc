=== about
A number that occurs again is looked for from the next block on, then from the start.
proves: nct-23.2.8-GOTO
=== main
GOTO1
N2 X99
N1 G0 X1
GOTO2
N1 X99
N2 X2
GOTO2
N3 X3
M30
N2 X4
GOTO3
=== truth
rapid 1 0 0
rapid 2 0 0
rapid 4 0 0
rapid 3 0 0
=== expect
file 0 main.nc
main.nc:1:1: warning[nct-repeated-n]: block number N1 occurs more than once: the next one is taken
    GOTO1
    ^~~~~
3 N1: rapid from 0 0 0 to 1 0 0 t0.004
main.nc:4:1: warning[nct-repeated-n]: block number N2 occurs more than once: the next one is taken
    GOTO2
    ^~~~~
6 N2: rapid to 2 0 0 t0.004
10 N2: rapid to 4 0 0 t0.008
8 N3: rapid to 3 0 0 t0.004
9: event end code="M30"
end of program: 9 blocks, 4 motions, 0 errors, 2 warnings
