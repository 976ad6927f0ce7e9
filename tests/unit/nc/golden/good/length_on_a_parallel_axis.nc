=== about
G43 W H3: the length acts on W; H4 on Y behind it leaves it there. Each axis with its own sign.
proves: nct-15.3-AXES nct-15.3-G43 nct-15.3-G44
=== settings
axis = W 4 linear parallel Z
N1416.ZAX = 0
H3 = 30
H4 = 4
=== main
G0 G43 W10 H3
Y5 H4
Z1
G49 W0 Y0 Z0
G44 W10 H3
M30
=== truth
0 0 40
0 9 40
0 9 41
0 0 0
0 0 -20
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 40 t0.16
2: rapid to 0 9 40 t0.036
3: rapid to 0 9 41 t0.004
4: rapid to 0 0 0 t0.16
5: rapid to 0 0 -20 t0.08
6: event end code="M30"
end of program: 6 blocks, 5 motions, 0 errors, 0 warnings
