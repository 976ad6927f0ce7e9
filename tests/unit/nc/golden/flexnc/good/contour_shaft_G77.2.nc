=== about
Contour of a shaft: G77.2A20Y30G37P0C2K1. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.4-G77.2 fnc-3.1-contour fnc-3.1-K
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G77.2A20Y30G37P0C2K1
G81X200Z100
M02
=== truth
12 0 0
10 0 0
32.606622 0 -30
34.606622 0 -30
34.606622 0 0
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G77.2 of line 4
1/1 depth 1: rapid from 100 0 50 to 12 0 0 t0.352
1/2 depth 1: feed to 10 0 0 F100 t1.2
1/3 depth 1: feed to 32.6066 0 -30 F100 t22.5384
1/4 depth 1: rapid to 34.6066 0 -30 t0.008
1/4 depth 1: rapid to 34.6066 0 0 t0.12
5: rapid to 100 0 100 t0.4
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 6 motions, 0 errors, 0 warnings
