=== about
Contour of a shaft: G03.1X60A50R20Z10P0C2K1. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.4-G3.1 fnc-3.1-contour fnc-3.1-K
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G03.1X60A50R20Z10P0C2K1
G81X200Z100
M02
=== truth
27 0 0
25 0 0
30 0 -10 center 44.675564 0 3.587782 sweep -32.461745
32 0 -10
32 0 0
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G3.1 of line 4
1/1 depth 1: rapid from 100 0 50 to 27 0 0 t0.292
1/2 depth 1: feed to 25 0 0 F100 t1.2
1/3 depth 1: feed arc to 30 0 -10 center 44.6756 0 3.5878 normal 0 1 0 sweep -32.4617 F100 t6.7988
1/4 depth 1: rapid to 32 0 -10 t0.008
1/4 depth 1: rapid to 32 0 0 t0.04
5: rapid to 100 0 100 t0.4
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 6 motions, 0 errors, 0 warnings
