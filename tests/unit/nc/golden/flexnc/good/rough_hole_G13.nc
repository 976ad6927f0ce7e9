=== about
Roughing of a hole: G13X20R18Z0P2C-3B2V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.3-G13 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G13X20R18Z0P2C-3B2V0
G81X200Z100
M02
=== truth
7 0 2
12 0 2
12 0 -17.888544
11.4 0 -17.888544
11.4 0 2
14 0 2
14 0 -17.549929
13.4 0 -17.549929
13.4 0 2
16 0 2
16 0 -16.970563
15.4 0 -16.970563
15.4 0 2
18 0 2
18 0 -16.124515
17.4 0 -16.124515
17.4 0 2
20 0 2
20 0 -14.96663
19.4 0 -14.96663
19.4 0 2
22 0 2
22 0 -13.416408
21.4 0 -13.416408
21.4 0 2
24 0 2
24 0 -11.313708
23.4 0 -11.313708
23.4 0 2
26 0 2
26 0 -8.246211
25.4 0 -8.246211
25.4 0 2
28 0 2
28 0 0
10 0 -18 center 10 0 0 sweep 90
10 0 2
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G13 of line 4
1/1 depth 1: rapid from 100 0 50 to 7 0 2 t0.372
1/2 depth 1: feed to 12 0 2 F100 t3
1/3 depth 1: feed to 12 0 -17.8885 F100 t11.9331
1/4 depth 1: feed to 11.4 0 -17.8885 F100 t0.36
1/5 depth 1: rapid to 11.4 0 2 t0.0796
1/6 depth 1: feed to 14 0 2 F100 t1.56
1/7 depth 1: feed to 14 0 -17.5499 F100 t11.73
1/8 depth 1: feed to 13.4 0 -17.5499 F100 t0.36
1/9 depth 1: rapid to 13.4 0 2 t0.0782
1/10 depth 1: feed to 16 0 2 F100 t1.56
1/11 depth 1: feed to 16 0 -16.9706 F100 t11.3823
1/12 depth 1: feed to 15.4 0 -16.9706 F100 t0.36
1/13 depth 1: rapid to 15.4 0 2 t0.0759
1/14 depth 1: feed to 18 0 2 F100 t1.56
1/15 depth 1: feed to 18 0 -16.1245 F100 t10.8747
1/16 depth 1: feed to 17.4 0 -16.1245 F100 t0.36
1/17 depth 1: rapid to 17.4 0 2 t0.0725
1/18 depth 1: feed to 20 0 2 F100 t1.56
1/19 depth 1: feed to 20 0 -14.9666 F100 t10.18
1/20 depth 1: feed to 19.4 0 -14.9666 F100 t0.36
1/21 depth 1: rapid to 19.4 0 2 t0.0679
1/22 depth 1: feed to 22 0 2 F100 t1.56
1/23 depth 1: feed to 22 0 -13.4164 F100 t9.2498
1/24 depth 1: feed to 21.4 0 -13.4164 F100 t0.36
1/25 depth 1: rapid to 21.4 0 2 t0.0617
1/26 depth 1: feed to 24 0 2 F100 t1.56
1/27 depth 1: feed to 24 0 -11.3137 F100 t7.9882
1/28 depth 1: feed to 23.4 0 -11.3137 F100 t0.36
1/29 depth 1: rapid to 23.4 0 2 t0.0533
1/30 depth 1: feed to 26 0 2 F100 t1.56
1/31 depth 1: feed to 26 0 -8.2462 F100 t6.1477
1/32 depth 1: feed to 25.4 0 -8.2462 F100 t0.36
1/33 depth 1: rapid to 25.4 0 2 t0.041
1/34 depth 1: feed to 28 0 2 F100 t1.56
1/35 depth 1: feed to 28 0 0 F100 t1.2
1/36 depth 1: feed arc to 10 0 -18 center 10 0 0 normal 0 1 0 sweep 90 F100 t16.9646
1/37 depth 1: rapid to 10 0 2 t0.08
5: rapid to 100 0 100 t0.392
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 38 motions, 0 errors, 0 warnings
