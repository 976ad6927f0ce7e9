=== about
Digest wl4, 2.5: without the operator blocks with / are left out, assignments too.
proves: wl4-4.5-slash
=== settings
control = wl4-mill
=== main
%SLASH
G54 #1=3
/ #1=7
N21 G1 Z5 F100
N22 X100
/ N23 G0 Z100 M0
N25 G1 Z20 Y#1
M30
%
=== truth
feed 0 0 5
feed 100 0 5
feed 100 3 20
=== expect
file 0 main.nc
4 N21: feed from 0 0 0 to 0 0 5 F100 t3
5 N22: feed to 100 0 5 F100 t60
7 N25: feed to 100 3 20 F100 t9.1782
8: event end code="M30"
end of program: 5 blocks, 3 motions, 0 errors, 0 warnings
