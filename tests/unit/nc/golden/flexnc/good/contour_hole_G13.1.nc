=== about
Contour of a hole: G13.1X20Y25R12G45P0C-3K1. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.5-G13.1 fnc-3.1-contour fnc-3.1-K
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G13.1X20Y25R12G45P0C-3K1
G81X200Z100
M02
=== truth
27.029437 0 0
30.029437 0 0
26.514719 0 -8.485281 center 18.029437 0 0 sweep 45
10 0 -25
10 0 0
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G13.1 of line 4
1/1 depth 1: rapid from 100 0 50 to 27.0294 0 0 t0.2919
1/2 depth 1: feed to 30.0294 0 0 F100 t1.8
1/3 depth 1: feed arc to 26.5147 0 -8.4853 center 18.0294 0 0 normal 0 1 0 sweep 45 F100 t5.6549
1/4 depth 1: feed to 10 0 -25 F100 t14.0132
1/5 depth 1: rapid to 10 0 0 t0.1
5: rapid to 100 0 100 t0.4
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 6 motions, 0 errors, 0 warnings
