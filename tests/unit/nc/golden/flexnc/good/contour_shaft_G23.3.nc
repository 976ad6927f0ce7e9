=== about
Contour of a shaft: G23.3X120Y48R10U12G45P0C2K1. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.4-G23.3 fnc-3.1-contour fnc-3.1-K
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G23.3X120Y48R10U12G45P0C2K1
G81X200Z100
M02
=== truth
4.887302 0 0
2.887302 0 0
9.958369 0 -2.928932 center 2.887302 0 -10 sweep 45
51.514719 0 -44.485281
60 0 -48 center 60 0 -36 sweep -45
62 0 -48
62 0 0
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G23.3 of line 4
1/1 depth 1: rapid from 100 0 50 to 4.8873 0 0 t0.3805
1/2 depth 1: feed to 2.8873 0 0 F100 t1.2
1/3 depth 1: feed arc to 9.9584 0 -2.9289 center 2.8873 0 -10 normal 0 1 0 sweep 45 F100 t4.7124
1/4 depth 1: feed to 51.5147 0 -44.4853 F100 t35.2617
1/5 depth 1: feed arc to 60 0 -48 center 60 0 -36 normal 0 1 0 sweep -45 F100 t5.6549
1/6 depth 1: rapid to 62 0 -48 t0.008
1/6 depth 1: rapid to 62 0 0 t0.192
5: rapid to 100 0 100 t0.4
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 8 motions, 0 errors, 0 warnings
