=== about
Contour of a shaft: G22.1X87Y19R15U18G45P0C2K1. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.4-G22.1 fnc-3.1-contour fnc-3.1-K
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G22.1X87Y19R15U18G45P0C2K1
G81X200Z100
M02
=== truth
27.742641 0 0
25.742641 0 0
36.349242 0 -4.393398 center 25.742641 0 -15 sweep 45
38.227922 0 -6.272078
43.5 0 -19 center 25.5 0 -19 sweep 45
45.5 0 -19
45.5 0 0
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G22.1 of line 4
1/1 depth 1: rapid from 100 0 50 to 27.7426 0 0 t0.289
1/2 depth 1: feed to 25.7426 0 0 F100 t1.2
1/3 depth 1: feed arc to 36.3492 0 -4.3934 center 25.7426 0 -15 normal 0 1 0 sweep 45 F100 t7.0686
1/4 depth 1: feed to 38.2279 0 -6.2721 F100 t1.5941
1/5 depth 1: feed arc to 43.5 0 -19 center 25.5 0 -19 normal 0 1 0 sweep 45 F100 t8.4823
1/6 depth 1: rapid to 45.5 0 -19 t0.008
1/6 depth 1: rapid to 45.5 0 0 t0.076
5: rapid to 100 0 100 t0.4
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 8 motions, 0 errors, 0 warnings
