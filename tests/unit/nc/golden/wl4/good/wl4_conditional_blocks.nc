=== about
Digest wl4, 2.5: blocks with / run only where the operator has set it.
proves: wl4-4.5-slash
=== settings
control = wl4-mill
param.CONDITIONAL = 1
=== main
%SLASH
G54
N20 G0 X0 Z1
N21 G1 Z5 F100
N22 X100
/ N23 G0 Z100 M0 $ the tool leaves for measuring
/ N24 Z5
N25 G1 Z20
M30
%
=== truth
rapid 0 0 1
feed 0 0 5
feed 100 0 5
rapid 100 0 100
rapid 100 0 5
feed 100 0 20
=== expect
file 0 main.nc
3 N20: rapid from 0 0 0 to 0 0 1 t0.004
4 N21: feed to 0 0 5 F100 t2.4
5 N22: feed to 100 0 5 F100 t60
6 N23: rapid to 100 0 100 t0.38
6 N23: event stop code="M0"
7 N24: rapid to 100 0 5 t0.38
8 N25: feed to 100 0 20 F100 t9
9: event end code="M30"
end of program: 8 blocks, 6 motions, 0 errors, 0 warnings
