=== about
Repetitions come first, then the jump of M99 P. The name with four digits goes first. The first parenthesis closes a comment. Of two equal
block numbers the next one is taken.
proves: nct-14.4.3-M99P nct-14.4.2-M98P nct-14.3-comment nct-14.1-N
=== main
M98 P11 L3
X999
N5 G0 X5 (a (b) Z5
M98 P1234
GOTO7
N7 X7
N7 Y7
M30
=== sub O0011
G91 G0 Y1
G90
M99 P5
=== sub O1234
Z6
M99
=== sub O00001234
Z999
M99
=== truth
0 1 0
0 2 0
0 3 0
5 3 5
5 3 6
7 3 6
7 7 6
=== expect
file 0 main.nc
file 1 O0011
1/1 depth 1: rapid from 0 0 0 to 0 1 0 t0.004
1/1 depth 1: rapid to 0 2 0 t0.004
1/1 depth 1: rapid to 0 3 0 t0.004
3 N5: rapid to 5 3 5 t0.02
file 2 O1234
2/1 depth 1: rapid to 5 3 6 t0.004
main.nc:5:1: warning[nct-repeated-n]: block number N7 occurs more than once: the next one is taken
    GOTO7
    ^~~~~
6 N7: rapid to 7 3 6 t0.008
7 N7: rapid to 7 7 6 t0.016
8: event end code="M30"
end of program: 18 blocks, 7 motions, 0 errors, 1 warnings
