=== about
Roughing of a hole: G77.1X20Y15Z5G38C-3P2B3V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.3-G77.1 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G77.1X20Y15Z5G38C-3P2B3V0
G81X200Z100
M02
=== truth
7 0 3
12 0 3
12 0 -17.440117
11.4 0 -17.440117
11.4 0 3
14 0 3
14 0 -14.880233
13.4 0 -14.880233
13.4 0 3
16 0 3
16 0 -12.32035
15.4 0 -12.32035
15.4 0 3
18 0 3
18 0 -9.760467
17.4 0 -9.760467
17.4 0 3
20 0 3
20 0 -7.200584
19.4 0 -7.200584
19.4 0 3
21.719284 0 3
21.719284 0 -5
10 0 -20
10 0 3
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G77.1 of line 4
1/1 depth 1: rapid from 100 0 50 to 7 0 3 t0.372
1/2 depth 1: feed to 12 0 3 F100 t3
1/3 depth 1: feed to 12 0 -17.4401 F100 t12.2641
1/4 depth 1: feed to 11.4 0 -17.4401 F100 t0.36
1/5 depth 1: rapid to 11.4 0 3 t0.0818
1/6 depth 1: feed to 14 0 3 F100 t1.56
1/7 depth 1: feed to 14 0 -14.8802 F100 t10.7281
1/8 depth 1: feed to 13.4 0 -14.8802 F100 t0.36
1/9 depth 1: rapid to 13.4 0 3 t0.0715
1/10 depth 1: feed to 16 0 3 F100 t1.56
1/11 depth 1: feed to 16 0 -12.3204 F100 t9.1922
1/12 depth 1: feed to 15.4 0 -12.3204 F100 t0.36
1/13 depth 1: rapid to 15.4 0 3 t0.0613
1/14 depth 1: feed to 18 0 3 F100 t1.56
1/15 depth 1: feed to 18 0 -9.7605 F100 t7.6563
1/16 depth 1: feed to 17.4 0 -9.7605 F100 t0.36
1/17 depth 1: rapid to 17.4 0 3 t0.051
1/18 depth 1: feed to 20 0 3 F100 t1.56
1/19 depth 1: feed to 20 0 -7.2006 F100 t6.1204
1/20 depth 1: feed to 19.4 0 -7.2006 F100 t0.36
1/21 depth 1: rapid to 19.4 0 3 t0.0408
1/22 depth 1: feed to 21.7193 0 3 F100 t1.3916
1/23 depth 1: feed to 21.7193 0 -5 F100 t4.8
1/24 depth 1: feed to 10 0 -20 F100 t11.4212
1/25 depth 1: rapid to 10 0 3 t0.092
5: rapid to 100 0 100 t0.388
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 26 motions, 0 errors, 0 warnings
