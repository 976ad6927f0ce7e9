=== about
Contour of a hole: G23.3X15Y50R12U16G43P0C-2K1. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.5-G23.3 fnc-3.1-contour fnc-3.1-K
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G23.3X15Y50R12U16G43P0C-2K1
G81X200Z100
M02
=== truth
64.300501 0 0
66.300501 0 0
57.524256 0 -3.81602 center 66.300501 0 -12 sweep -47
19.201659 0 -44.911974
7.5 0 -50 center 7.5 0 -34 sweep 47
7.5 0 0
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G23.3 of line 4
1/1 depth 1: rapid from 100 0 50 to 64.3005 0 0 t0.2
1/2 depth 1: feed to 66.3005 0 0 F100 t1.2
1/3 depth 1: feed arc to 57.5243 0 -3.816 center 66.3005 0 -12 normal 0 1 0 sweep -47 F100 t5.9062
1/4 depth 1: feed to 19.2017 0 -44.912 F100 t33.715
1/5 depth 1: feed arc to 7.5 0 -50 center 7.5 0 -34 normal 0 1 0 sweep 47 F100 t7.8749
1/6 depth 1: rapid to 7.5 0 0 t0.2
5: rapid to 100 0 100 t0.4
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 7 motions, 0 errors, 0 warnings
