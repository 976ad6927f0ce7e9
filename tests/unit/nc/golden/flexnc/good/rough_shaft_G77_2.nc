=== about
Roughing of a shaft: G77X60A40Y0Z20P3C2B2V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.2-G77 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G77X60A40Y0Z20P3C2B2V0
G81X200Z100
M02
=== truth
32 0 2
27 0 2
27 0 -20
27.4 0 -20
27.4 0 2
24 0 2
24 0 -20
24.4 0 -20
24.4 0 2
21 0 2
21 0 -20
21.4 0 -20
21.4 0 2
20 0 2
20 0 -20
30 0 -20
32 0 -20
32 0 2
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G77 of line 4
1/1 depth 1: rapid from 100 0 50 to 32 0 2 t0.272
1/2 depth 1: feed to 27 0 2 F100 t3
1/3 depth 1: feed to 27 0 -20 F100 t13.2
1/4 depth 1: feed to 27.4 0 -20 F100 t0.24
1/5 depth 1: rapid to 27.4 0 2 t0.088
1/6 depth 1: feed to 24 0 2 F100 t2.04
1/7 depth 1: feed to 24 0 -20 F100 t13.2
1/8 depth 1: feed to 24.4 0 -20 F100 t0.24
1/9 depth 1: rapid to 24.4 0 2 t0.088
1/10 depth 1: feed to 21 0 2 F100 t2.04
1/11 depth 1: feed to 21 0 -20 F100 t13.2
1/12 depth 1: feed to 21.4 0 -20 F100 t0.24
1/13 depth 1: rapid to 21.4 0 2 t0.088
1/14 depth 1: feed to 20 0 2 F100 t0.84
1/15 depth 1: feed to 20 0 -20 F100 t13.2
1/16 depth 1: feed to 30 0 -20 F100 t6
1/17 depth 1: rapid to 32 0 -20 t0.008
1/18 depth 1: rapid to 32 0 2 t0.088
5: rapid to 100 0 100 t0.392
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 19 motions, 0 errors, 0 warnings
