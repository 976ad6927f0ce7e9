=== about
Contour of a shaft: G12.3A20Y30R10G45P0C2K1. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.4-G12.3 fnc-3.1-contour fnc-3.1-K
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G12.3A20Y30R10G45P0C2K1
G81X200Z100
M02
=== truth
7.857864 0 0
5.857864 0 0
12.928932 0 -2.928932 center 5.857864 0 -10 sweep 45
40 0 -30
42 0 -30
42 0 0
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G12.3 of line 4
1/1 depth 1: rapid from 100 0 50 to 7.8579 0 0 t0.3686
1/2 depth 1: feed to 5.8579 0 0 F100 t1.2
1/3 depth 1: feed arc to 12.9289 0 -2.9289 center 5.8579 0 -10 normal 0 1 0 sweep 45 F100 t4.7124
1/4 depth 1: feed to 40 0 -30 F100 t22.9706
1/5 depth 1: rapid to 42 0 -30 t0.008
1/5 depth 1: rapid to 42 0 0 t0.12
5: rapid to 100 0 100 t0.4
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 7 motions, 0 errors, 0 warnings
