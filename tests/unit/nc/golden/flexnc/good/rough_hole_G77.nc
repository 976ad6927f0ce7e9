=== about
Roughing of a hole: G77X10A40Y15Z0C-2P1.5B2V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.3-G77 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G77X10A40Y15Z0C-2P1.5B2V0
G81X200Z100
M02
=== truth
3 0 2
6.5 0 2
6.5 0 -13.5
6.1 0 -13.5
6.1 0 2
8 0 2
8 0 -12
7.6 0 -12
7.6 0 2
9.5 0 2
9.5 0 -10.5
9.1 0 -10.5
9.1 0 2
11 0 2
11 0 -9
10.6 0 -9
10.6 0 2
12.5 0 2
12.5 0 -7.5
12.1 0 -7.5
12.1 0 2
14 0 2
14 0 -6
13.6 0 -6
13.6 0 2
15.5 0 2
15.5 0 -4.5
15.1 0 -4.5
15.1 0 2
17 0 2
17 0 -3
16.6 0 -3
16.6 0 2
18.5 0 2
18.5 0 -1.5
18.1 0 -1.5
18.1 0 2
20 0 2
20 0 0
5 0 -15
5 0 2
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G77 of line 4
1/1 depth 1: rapid from 100 0 50 to 3 0 2 t0.388
1/2 depth 1: feed to 6.5 0 2 F100 t2.1
1/3 depth 1: feed to 6.5 0 -13.5 F100 t9.3
1/4 depth 1: feed to 6.1 0 -13.5 F100 t0.24
1/5 depth 1: rapid to 6.1 0 2 t0.062
1/6 depth 1: feed to 8 0 2 F100 t1.14
1/7 depth 1: feed to 8 0 -12 F100 t8.4
1/8 depth 1: feed to 7.6 0 -12 F100 t0.24
1/9 depth 1: rapid to 7.6 0 2 t0.056
1/10 depth 1: feed to 9.5 0 2 F100 t1.14
1/11 depth 1: feed to 9.5 0 -10.5 F100 t7.5
1/12 depth 1: feed to 9.1 0 -10.5 F100 t0.24
1/13 depth 1: rapid to 9.1 0 2 t0.05
1/14 depth 1: feed to 11 0 2 F100 t1.14
1/15 depth 1: feed to 11 0 -9 F100 t6.6
1/16 depth 1: feed to 10.6 0 -9 F100 t0.24
1/17 depth 1: rapid to 10.6 0 2 t0.044
1/18 depth 1: feed to 12.5 0 2 F100 t1.14
1/19 depth 1: feed to 12.5 0 -7.5 F100 t5.7
1/20 depth 1: feed to 12.1 0 -7.5 F100 t0.24
1/21 depth 1: rapid to 12.1 0 2 t0.038
1/22 depth 1: feed to 14 0 2 F100 t1.14
1/23 depth 1: feed to 14 0 -6 F100 t4.8
1/24 depth 1: feed to 13.6 0 -6 F100 t0.24
1/25 depth 1: rapid to 13.6 0 2 t0.032
1/26 depth 1: feed to 15.5 0 2 F100 t1.14
1/27 depth 1: feed to 15.5 0 -4.5 F100 t3.9
1/28 depth 1: feed to 15.1 0 -4.5 F100 t0.24
1/29 depth 1: rapid to 15.1 0 2 t0.026
1/30 depth 1: feed to 17 0 2 F100 t1.14
1/31 depth 1: feed to 17 0 -3 F100 t3
1/32 depth 1: feed to 16.6 0 -3 F100 t0.24
1/33 depth 1: rapid to 16.6 0 2 t0.02
1/34 depth 1: feed to 18.5 0 2 F100 t1.14
1/35 depth 1: feed to 18.5 0 -1.5 F100 t2.1
1/36 depth 1: feed to 18.1 0 -1.5 F100 t0.24
1/37 depth 1: rapid to 18.1 0 2 t0.014
1/38 depth 1: feed to 20 0 2 F100 t1.14
1/39 depth 1: feed to 20 0 0 F100 t1.2
1/40 depth 1: feed to 5 0 -15 F100 t12.7279
1/41 depth 1: rapid to 5 0 2 t0.068
5: rapid to 100 0 100 t0.392
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 42 motions, 0 errors, 0 warnings
