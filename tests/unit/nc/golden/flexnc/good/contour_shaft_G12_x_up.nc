=== about
Contour of a shaft: G12X40R15P0C2K1. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.4-G12 fnc-3.1-contour fnc-3.1-K
=== settings
control = flexnc
start = 100 0 50
param.arc_view = 1
=== main
T1M06D1
S300M03
G98F100
G12X40R15P0C2K1
G81X200Z100
M02
=== truth
7 0 0
5 0 0
20 0 -15 center 20 0 0 sweep -90
22 0 -15
22 0 0
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G12 of line 4
1/1 depth 1: rapid from 100 0 50 to 7 0 0 t0.372
1/2 depth 1: feed to 5 0 0 F100 t1.2
1/3 depth 1: feed arc to 20 0 -15 center 20 0 0 normal 0 1 0 sweep -90 F100 t14.1372
1/4 depth 1: rapid to 22 0 -15 t0.008
1/4 depth 1: rapid to 22 0 0 t0.06
5: rapid to 100 0 100 t0.4
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 6 motions, 0 errors, 0 warnings
