=== about
Contour of a hole: G12.5X10A70R15G45P0C-3K1. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.5-G12.5 fnc-3.1-contour fnc-3.1-K
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G12.5X10A70R15G45P0C-3K1
G81X200Z100
M02
=== truth
32 0 0
35 0 0
24.393398 0 -4.393398 center 35 0 -15 sweep -45
5 0 -23.786797
5 0 0
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G12.5 of line 4
1/1 depth 1: rapid from 100 0 50 to 32 0 0 t0.272
1/2 depth 1: feed to 35 0 0 F100 t1.8
1/3 depth 1: feed arc to 24.3934 0 -4.3934 center 35 0 -15 normal 0 1 0 sweep -45 F100 t7.0686
1/4 depth 1: feed to 5 0 -23.7868 F100 t16.4558
1/5 depth 1: rapid to 5 0 0 t0.0951
5: rapid to 100 0 100 t0.4
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 6 motions, 0 errors, 0 warnings
