=== about
Roughing of a shaft: G03.1X60A50R20Z10P1.5B2C2V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.2-G3.1 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G03.1X60A50R20Z10P1.5B2C2V0
G81X200Z100
M02
=== truth
32 0 2
28.5 0 2
28.5 0 -8.174494
28.9 0 -8.174494
28.9 0 2
27 0 2
27 0 -5.770339
27.4 0 -5.770339
27.4 0 2
25.5 0 2
25.5 0 -2.095328
25.9 0 -2.095328
25.9 0 2
25 0 2
25 0 0
30 0 -10 center 44.675564 0 3.587782 sweep -32.461745
32 0 -10
32 0 2
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G3.1 of line 4
1/1 depth 1: rapid from 100 0 50 to 32 0 2 t0.272
1/2 depth 1: feed to 28.5 0 2 F100 t2.1
1/3 depth 1: feed to 28.5 0 -8.1745 F100 t6.1047
1/4 depth 1: feed to 28.9 0 -8.1745 F100 t0.24
1/5 depth 1: rapid to 28.9 0 2 t0.0407
1/6 depth 1: feed to 27 0 2 F100 t1.14
1/7 depth 1: feed to 27 0 -5.7703 F100 t4.6622
1/8 depth 1: feed to 27.4 0 -5.7703 F100 t0.24
1/9 depth 1: rapid to 27.4 0 2 t0.0311
1/10 depth 1: feed to 25.5 0 2 F100 t1.14
1/11 depth 1: feed to 25.5 0 -2.0953 F100 t2.4572
1/12 depth 1: feed to 25.9 0 -2.0953 F100 t0.24
1/13 depth 1: rapid to 25.9 0 2 t0.0164
1/14 depth 1: feed to 25 0 2 F100 t0.54
1/15 depth 1: feed to 25 0 0 F100 t1.2
1/16 depth 1: feed arc to 30 0 -10 center 44.6756 0 3.5878 normal 0 1 0 sweep -32.4617 F100 t6.7988
1/17 depth 1: rapid to 32 0 -10 t0.008
1/18 depth 1: rapid to 32 0 2 t0.048
5: rapid to 100 0 100 t0.392
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 19 motions, 0 errors, 0 warnings
