=== about
Contour of a shaft: G22.3A87Y48R10U12G55P0C2K1. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.4-G22.3 fnc-3.1-contour fnc-3.1-K
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G22.3A87Y48R10U12G55P0C2K1
G81X200Z100
M02
=== truth
42.347012 0 0
40.347012 0 0
46.082776 0 -1.80848 center 40.347012 0 -10 sweep 35
98.01266 0 -38.170175
103.129743 0 -48 center 91.129743 0 -48 sweep 55
105.129743 0 -48
105.129743 0 0
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G22.3 of line 4
1/1 depth 1: rapid from 100 0 50 to 42.347 0 0 t0.2306
1/2 depth 1: feed to 40.347 0 0 F100 t1.2
1/3 depth 1: feed arc to 46.0828 0 -1.8085 center 40.347 0 -10 normal 0 1 0 sweep 35 F100 t3.6652
1/4 depth 1: feed to 98.0127 0 -38.1702 F100 t38.0368
1/5 depth 1: feed arc to 103.1297 0 -48 center 91.1297 0 -48 normal 0 1 0 sweep 55 F100 t6.9115
1/6 depth 1: rapid to 105.1297 0 -48 t0.008
1/6 depth 1: rapid to 105.1297 0 0 t0.192
5: rapid to 100 0 100 t0.4
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 8 motions, 0 errors, 0 warnings
