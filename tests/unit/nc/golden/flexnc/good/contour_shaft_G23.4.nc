=== about
Contour of a shaft: G23.4A15Y48R10U12G45P0C2K1. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.4-G23.4 fnc-3.1-contour fnc-3.1-K
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G23.4A15Y48R10U12G45P0C2K1
G81X200Z100
M02
=== truth
9.5 0 0
7.5 0 0
14.571068 0 -2.928932 center 7.5 0 -10 sweep 45
56.127417 0 -44.485281
64.612698 0 -48 center 64.612698 0 -36 sweep -45
66.612698 0 -48
66.612698 0 0
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G23.4 of line 4
1/1 depth 1: rapid from 100 0 50 to 9.5 0 0 t0.362
1/2 depth 1: feed to 7.5 0 0 F100 t1.2
1/3 depth 1: feed arc to 14.5711 0 -2.9289 center 7.5 0 -10 normal 0 1 0 sweep 45 F100 t4.7124
1/4 depth 1: feed to 56.1274 0 -44.4853 F100 t35.2617
1/5 depth 1: feed arc to 64.6127 0 -48 center 64.6127 0 -36 normal 0 1 0 sweep -45 F100 t5.6549
1/6 depth 1: rapid to 66.6127 0 -48 t0.008
1/6 depth 1: rapid to 66.6127 0 0 t0.192
5: rapid to 100 0 100 t0.4
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 8 motions, 0 errors, 0 warnings
