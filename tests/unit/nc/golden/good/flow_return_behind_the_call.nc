=== about
M99 returns to the block behind the call; M99 P from a subprogram goes backwards too.
proves: nct-14.4.3-M99 nct-14.4.3-M99P
=== main
#1=0
N101 M98 P11
N102 G0 X102
GOTO200
N150 X150
M30
N200 M98 P12
N201 X201
=== sub O0011
G0 X11
M99
=== sub O0012
X12
M99 P150
=== truth
11 0 0
102 0 0
12 0 0
150 0 0
=== expect
file 0 main.nc
file 1 O0011
1/1 depth 1: rapid from 0 0 0 to 11 0 0 t0.044
3 N102: rapid to 102 0 0 t0.364
file 2 O0012
2/1 depth 1: rapid to 12 0 0 t0.36
5 N150: rapid to 150 0 0 t0.552
6: event end code="M30"
end of program: 11 blocks, 4 motions, 0 errors, 0 warnings
