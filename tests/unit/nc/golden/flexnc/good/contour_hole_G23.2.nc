=== about
Contour of a hole: G23.2A130Y50R12U16G43P0C-2K1. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.5-G23.2 fnc-3.1-contour fnc-3.1-K
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G23.2A130Y50R12U16G43P0C-2K1
G81X200Z100
M02
=== truth
68.217748 0 0
70.217748 0 0
61.441504 0 -3.81602 center 70.217748 0 -12 sweep -47
23.118907 0 -44.911974
11.417248 0 -50 center 11.417248 0 -34 sweep 47
11.417248 0 0
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G23.2 of line 4
1/1 depth 1: rapid from 100 0 50 to 68.2177 0 0 t0.2
1/2 depth 1: feed to 70.2177 0 0 F100 t1.2
1/3 depth 1: feed arc to 61.4415 0 -3.816 center 70.2177 0 -12 normal 0 1 0 sweep -47 F100 t5.9062
1/4 depth 1: feed to 23.1189 0 -44.912 F100 t33.715
1/5 depth 1: feed arc to 11.4172 0 -50 center 11.4172 0 -34 normal 0 1 0 sweep 47 F100 t7.8749
1/6 depth 1: rapid to 11.4172 0 0 t0.2
5: rapid to 100 0 100 t0.4
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 7 motions, 0 errors, 0 warnings
