=== about
Contour of a hole: G13.2A120Y25R12G45P0C-3K1. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.5-G13.2 fnc-3.1-contour fnc-3.1-K
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G13.2A120Y25R12G45P0C-3K1
G81X200Z100
M02
=== truth
57 0 0
60 0 0
56.485281 0 -8.485281 center 48 0 0 sweep 45
39.970563 0 -25
39.970563 0 0
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G13.2 of line 4
1/1 depth 1: rapid from 100 0 50 to 57 0 0 t0.2
1/2 depth 1: feed to 60 0 0 F100 t1.8
1/3 depth 1: feed arc to 56.4853 0 -8.4853 center 48 0 0 normal 0 1 0 sweep 45 F100 t5.6549
1/4 depth 1: feed to 39.9706 0 -25 F100 t14.0132
1/5 depth 1: rapid to 39.9706 0 0 t0.1
5: rapid to 100 0 100 t0.4
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 6 motions, 0 errors, 0 warnings
