=== about
Contour of a hole: G77.1X20Y15G38P0C-3K1. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.5-G77.1 fnc-3.1-contour fnc-3.1-K
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G77.1X20Y15G38P0C-3K1
G81X200Z100
M02
=== truth
18.719284 0 0
21.719284 0 0
10 0 -15
10 0 0
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G77.1 of line 4
1/1 depth 1: rapid from 100 0 50 to 18.7193 0 0 t0.3251
1/2 depth 1: feed to 21.7193 0 0 F100 t1.8
1/3 depth 1: feed to 10 0 -15 F100 t11.4212
1/4 depth 1: rapid to 10 0 0 t0.06
5: rapid to 100 0 100 t0.4
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 5 motions, 0 errors, 0 warnings
