=== about
Contour of a shaft: G13.5X80A8R10G45P0C2K1. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.4-G13.5 fnc-3.1-contour fnc-3.1-K
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G13.5X80A8R10G45P0C2K1
G81X200Z100
M02
=== truth
6 0 0
4 0 0
6.928932 0 -7.071068 center 14 0 0 sweep -45
40 0 -40.142136
42 0 -40.142136
42 0 0
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G13.5 of line 4
1/1 depth 1: rapid from 100 0 50 to 6 0 0 t0.376
1/2 depth 1: feed to 4 0 0 F100 t1.2
1/3 depth 1: feed arc to 6.9289 0 -7.0711 center 14 0 0 normal 0 1 0 sweep -45 F100 t4.7124
1/4 depth 1: feed to 40 0 -40.1421 F100 t28.0617
1/5 depth 1: rapid to 42 0 -40.1421 t0.008
1/5 depth 1: rapid to 42 0 0 t0.1606
5: rapid to 100 0 100 t0.4
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 7 motions, 0 errors, 0 warnings
