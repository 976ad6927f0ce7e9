=== about
Roughing of a hole: G13.1X20Y25Z0G45R12C-3P2B3V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.3-G13.1 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G13.1X20Y25Z0G45R12C-3P2B3V0
G81X200Z100
M02
=== truth
7 0 3
12 0 3
12 0 -23
11.4 0 -23
11.4 0 3
14 0 3
14 0 -21
13.4 0 -21
13.4 0 3
16 0 3
16 0 -19
15.4 0 -19
15.4 0 3
18 0 3
18 0 -17
17.4 0 -17
17.4 0 3
20 0 3
20 0 -15
19.4 0 -15
19.4 0 3
22 0 3
22 0 -13
21.4 0 -13
21.4 0 3
24 0 3
24 0 -11
23.4 0 -11
23.4 0 3
26 0 3
26 0 -9
25.4 0 -9
25.4 0 3
26.514719 0 3
26.514719 0 -8.485281
25.914719 0 -8.485281
25.914719 0 3
28.514719 0 3
28.514719 0 -5.835998
27.914719 0 -5.835998
27.914719 0 3
30.029437 0 3
30.029437 0 0
26.514719 0 -8.485281 center 18.029437 0 0 sweep 45
10 0 -25
10 0 3
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G13.1 of line 4
1/1 depth 1: rapid from 100 0 50 to 7 0 3 t0.372
1/2 depth 1: feed to 12 0 3 F100 t3
1/3 depth 1: feed to 12 0 -23 F100 t15.6
1/4 depth 1: feed to 11.4 0 -23 F100 t0.36
1/5 depth 1: rapid to 11.4 0 3 t0.104
1/6 depth 1: feed to 14 0 3 F100 t1.56
1/7 depth 1: feed to 14 0 -21 F100 t14.4
1/8 depth 1: feed to 13.4 0 -21 F100 t0.36
1/9 depth 1: rapid to 13.4 0 3 t0.096
1/10 depth 1: feed to 16 0 3 F100 t1.56
1/11 depth 1: feed to 16 0 -19 F100 t13.2
1/12 depth 1: feed to 15.4 0 -19 F100 t0.36
1/13 depth 1: rapid to 15.4 0 3 t0.088
1/14 depth 1: feed to 18 0 3 F100 t1.56
1/15 depth 1: feed to 18 0 -17 F100 t12
1/16 depth 1: feed to 17.4 0 -17 F100 t0.36
1/17 depth 1: rapid to 17.4 0 3 t0.08
1/18 depth 1: feed to 20 0 3 F100 t1.56
1/19 depth 1: feed to 20 0 -15 F100 t10.8
1/20 depth 1: feed to 19.4 0 -15 F100 t0.36
1/21 depth 1: rapid to 19.4 0 3 t0.072
1/22 depth 1: feed to 22 0 3 F100 t1.56
1/23 depth 1: feed to 22 0 -13 F100 t9.6
1/24 depth 1: feed to 21.4 0 -13 F100 t0.36
1/25 depth 1: rapid to 21.4 0 3 t0.064
1/26 depth 1: feed to 24 0 3 F100 t1.56
1/27 depth 1: feed to 24 0 -11 F100 t8.4
1/28 depth 1: feed to 23.4 0 -11 F100 t0.36
1/29 depth 1: rapid to 23.4 0 3 t0.056
1/30 depth 1: feed to 26 0 3 F100 t1.56
1/31 depth 1: feed to 26 0 -9 F100 t7.2
1/32 depth 1: feed to 25.4 0 -9 F100 t0.36
1/33 depth 1: rapid to 25.4 0 3 t0.048
1/34 depth 1: feed to 26.5147 0 3 F100 t0.6688
1/35 depth 1: feed to 26.5147 0 -8.4853 F100 t6.8912
1/36 depth 1: feed to 25.9147 0 -8.4853 F100 t0.36
1/37 depth 1: rapid to 25.9147 0 3 t0.0459
1/38 depth 1: feed to 28.5147 0 3 F100 t1.56
1/39 depth 1: feed to 28.5147 0 -5.836 F100 t5.3016
1/40 depth 1: feed to 27.9147 0 -5.836 F100 t0.36
1/41 depth 1: rapid to 27.9147 0 3 t0.0353
1/42 depth 1: feed to 30.0294 0 3 F100 t1.2688
1/43 depth 1: feed to 30.0294 0 0 F100 t1.8
1/44 depth 1: feed arc to 26.5147 0 -8.4853 center 18.0294 0 0 normal 0 1 0 sweep 45 F100 t5.6549
1/45 depth 1: feed to 10 0 -25 F100 t14.0132
1/46 depth 1: rapid to 10 0 3 t0.112
5: rapid to 100 0 100 t0.388
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 47 motions, 0 errors, 0 warnings
