=== about
Contour of a shaft: G23.1X88Y27R14U18G44P0C2K1. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.4-G23.1 fnc-3.1-contour fnc-3.1-K
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G23.1X88Y27R14U18G44P0C2K1
G81X200Z100
M02
=== truth
13.983756 0 0
11.983756 0 0
22.054513 0 -4.274783 center 11.983756 0 -14 sweep 46
38.69243 0 -21.503851
51.640547 0 -27 center 51.640547 0 -9 sweep -46
53.640547 0 -27
53.640547 0 0
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G23.1 of line 4
1/1 depth 1: rapid from 100 0 50 to 13.9838 0 0 t0.3441
1/2 depth 1: feed to 11.9838 0 0 F100 t1.2
1/3 depth 1: feed arc to 22.0545 0 -4.2748 center 11.9838 0 -14 normal 0 1 0 sweep 46 F100 t6.744
1/4 depth 1: feed to 38.6924 0 -21.5039 F100 t14.3707
1/5 depth 1: feed arc to 51.6405 0 -27 center 51.6405 0 -9 normal 0 1 0 sweep -46 F100 t8.6708
1/6 depth 1: rapid to 53.6405 0 -27 t0.008
1/6 depth 1: rapid to 53.6405 0 0 t0.108
5: rapid to 100 0 100 t0.4
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 8 motions, 0 errors, 0 warnings
