=== about
Contour of a shaft: G8.1X79A26R14U17P0C2K1. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.4-G8.1 fnc-3.1-contour fnc-3.1-K
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G8.1X79A26R14U17P0C2K1
G81X200Z100
M02
=== truth
15 0 0
13 0 0
24.967742 0 -6.735487 center 13 0 -14 sweep 58.741921
39.5 0 -14.914292 center 39.5 0 2.085708 sweep -58.741921
41.5 0 -14.914292
41.5 0 0
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G8.1 of line 4
1/1 depth 1: rapid from 100 0 50 to 15 0 0 t0.34
1/2 depth 1: feed to 13 0 0 F100 t1.2
1/3 depth 1: feed arc to 24.9677 0 -6.7355 center 13 0 -14 normal 0 1 0 sweep 58.7419 F100 t8.612
1/4 depth 1: feed arc to 39.5 0 -14.9143 center 39.5 0 2.0857 normal 0 1 0 sweep -58.7419 F100 t10.4574
1/5 depth 1: rapid to 41.5 0 -14.9143 t0.008
1/5 depth 1: rapid to 41.5 0 0 t0.0597
5: rapid to 100 0 100 t0.4
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 7 motions, 0 errors, 0 warnings
