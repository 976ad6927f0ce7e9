=== about
Contour of a shaft: G23.2A25Y48R10U12G55P0C2K1. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.4-G23.2 fnc-3.1-contour fnc-3.1-K
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G23.2A25Y48R10U12G55P0C2K1
G81X200Z100
M02
=== truth
11.347012 0 0
9.347012 0 0
15.082776 0 -1.80848 center 9.347012 0 -10 sweep 35
77.951773 0 -45.829825
84.83469 0 -48 center 84.83469 0 -36 sweep -35
86.83469 0 -48
86.83469 0 0
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G23.2 of line 4
1/1 depth 1: rapid from 100 0 50 to 11.347 0 0 t0.3546
1/2 depth 1: feed to 9.347 0 0 F100 t1.2
1/3 depth 1: feed arc to 15.0828 0 -1.8085 center 9.347 0 -10 normal 0 1 0 sweep 35 F100 t3.6652
1/4 depth 1: feed to 77.9518 0 -45.8298 F100 t46.0493
1/5 depth 1: feed arc to 84.8347 0 -48 center 84.8347 0 -36 normal 0 1 0 sweep -35 F100 t4.3982
1/6 depth 1: rapid to 86.8347 0 -48 t0.008
1/6 depth 1: rapid to 86.8347 0 0 t0.192
5: rapid to 100 0 100 t0.4
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 8 motions, 0 errors, 0 warnings
