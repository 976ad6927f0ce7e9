=== about
Contour of a shaft: G12.5X90A0R10G55P0C2K1. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.4-G12.5 fnc-3.1-contour fnc-3.1-K
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G12.5X90A0R10G55P0C2K1
G81X200Z100
M02
=== truth
2 0 0
0 0 0
5.735764 0 -1.80848 center 0 0 -10 sweep 35
45 0 -29.301593
47 0 -29.301593
47 0 0
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G12.5 of line 4
1/1 depth 1: rapid from 100 0 50 to 2 0 0 t0.392
1/2 depth 1: feed to 0 0 0 F100 t1.2
1/3 depth 1: feed arc to 5.7358 0 -1.8085 center 0 0 -10 normal 0 1 0 sweep 35 F100 t3.6652
1/4 depth 1: feed to 45 0 -29.3016 F100 t28.7597
1/5 depth 1: rapid to 47 0 -29.3016 t0.008
1/5 depth 1: rapid to 47 0 0 t0.1172
5: rapid to 100 0 100 t0.4
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 7 motions, 0 errors, 0 warnings
