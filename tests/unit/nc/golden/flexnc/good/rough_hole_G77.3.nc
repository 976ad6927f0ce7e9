=== about
Roughing of a hole: G77.3A90X10Z12G38C-3P2B3V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.3-G77.3 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G77.3A90X10Z12G38C-3P2B3V0
G81X200Z100
M02
=== truth
2 0 3
7 0 3
7 0 -60.637782
6.4 0 -60.637782
6.4 0 3
9 0 3
9 0 -58.077899
8.4 0 -58.077899
8.4 0 3
11 0 3
11 0 -55.518015
10.4 0 -55.518015
10.4 0 3
13 0 3
13 0 -52.958132
12.4 0 -52.958132
12.4 0 3
15 0 3
15 0 -50.398249
14.4 0 -50.398249
14.4 0 3
17 0 3
17 0 -47.838366
16.4 0 -47.838366
16.4 0 3
19 0 3
19 0 -45.278482
18.4 0 -45.278482
18.4 0 3
21 0 3
21 0 -42.718599
20.4 0 -42.718599
20.4 0 3
23 0 3
23 0 -40.158716
22.4 0 -40.158716
22.4 0 3
25 0 3
25 0 -37.598833
24.4 0 -37.598833
24.4 0 3
27 0 3
27 0 -35.038949
26.4 0 -35.038949
26.4 0 3
29 0 3
29 0 -32.479066
28.4 0 -32.479066
28.4 0 3
31 0 3
31 0 -29.919183
30.4 0 -29.919183
30.4 0 3
33 0 3
33 0 -27.3593
32.4 0 -27.3593
32.4 0 3
35 0 3
35 0 -24.799416
34.4 0 -24.799416
34.4 0 3
37 0 3
37 0 -22.239533
36.4 0 -22.239533
36.4 0 3
39 0 3
39 0 -19.67965
38.4 0 -19.67965
38.4 0 3
41 0 3
41 0 -17.119767
40.4 0 -17.119767
40.4 0 3
43 0 3
43 0 -14.559883
42.4 0 -14.559883
42.4 0 3
45 0 3
45 0 -12
5 0 -63.197665
5 0 3
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G77.3 of line 4
1/1 depth 1: rapid from 100 0 50 to 2 0 3 t0.392
1/2 depth 1: feed to 7 0 3 F100 t3
1/3 depth 1: feed to 7 0 -60.6378 F100 t38.1827
1/4 depth 1: feed to 6.4 0 -60.6378 F100 t0.36
1/5 depth 1: rapid to 6.4 0 3 t0.2546
1/6 depth 1: feed to 9 0 3 F100 t1.56
1/7 depth 1: feed to 9 0 -58.0779 F100 t36.6467
1/8 depth 1: feed to 8.4 0 -58.0779 F100 t0.36
1/9 depth 1: rapid to 8.4 0 3 t0.2443
1/10 depth 1: feed to 11 0 3 F100 t1.56
1/11 depth 1: feed to 11 0 -55.518 F100 t35.1108
1/12 depth 1: feed to 10.4 0 -55.518 F100 t0.36
1/13 depth 1: rapid to 10.4 0 3 t0.2341
1/14 depth 1: feed to 13 0 3 F100 t1.56
1/15 depth 1: feed to 13 0 -52.9581 F100 t33.5749
1/16 depth 1: feed to 12.4 0 -52.9581 F100 t0.36
1/17 depth 1: rapid to 12.4 0 3 t0.2238
1/18 depth 1: feed to 15 0 3 F100 t1.56
1/19 depth 1: feed to 15 0 -50.3982 F100 t32.0389
1/20 depth 1: feed to 14.4 0 -50.3982 F100 t0.36
1/21 depth 1: rapid to 14.4 0 3 t0.2136
1/22 depth 1: feed to 17 0 3 F100 t1.56
1/23 depth 1: feed to 17 0 -47.8384 F100 t30.503
1/24 depth 1: feed to 16.4 0 -47.8384 F100 t0.36
1/25 depth 1: rapid to 16.4 0 3 t0.2034
1/26 depth 1: feed to 19 0 3 F100 t1.56
1/27 depth 1: feed to 19 0 -45.2785 F100 t28.9671
1/28 depth 1: feed to 18.4 0 -45.2785 F100 t0.36
1/29 depth 1: rapid to 18.4 0 3 t0.1931
1/30 depth 1: feed to 21 0 3 F100 t1.56
1/31 depth 1: feed to 21 0 -42.7186 F100 t27.4312
1/32 depth 1: feed to 20.4 0 -42.7186 F100 t0.36
1/33 depth 1: rapid to 20.4 0 3 t0.1829
1/34 depth 1: feed to 23 0 3 F100 t1.56
1/35 depth 1: feed to 23 0 -40.1587 F100 t25.8952
1/36 depth 1: feed to 22.4 0 -40.1587 F100 t0.36
1/37 depth 1: rapid to 22.4 0 3 t0.1726
1/38 depth 1: feed to 25 0 3 F100 t1.56
1/39 depth 1: feed to 25 0 -37.5988 F100 t24.3593
1/40 depth 1: feed to 24.4 0 -37.5988 F100 t0.36
1/41 depth 1: rapid to 24.4 0 3 t0.1624
1/42 depth 1: feed to 27 0 3 F100 t1.56
1/43 depth 1: feed to 27 0 -35.0389 F100 t22.8234
1/44 depth 1: feed to 26.4 0 -35.0389 F100 t0.36
1/45 depth 1: rapid to 26.4 0 3 t0.1522
1/46 depth 1: feed to 29 0 3 F100 t1.56
1/47 depth 1: feed to 29 0 -32.4791 F100 t21.2874
1/48 depth 1: feed to 28.4 0 -32.4791 F100 t0.36
1/49 depth 1: rapid to 28.4 0 3 t0.1419
1/50 depth 1: feed to 31 0 3 F100 t1.56
1/51 depth 1: feed to 31 0 -29.9192 F100 t19.7515
1/52 depth 1: feed to 30.4 0 -29.9192 F100 t0.36
1/53 depth 1: rapid to 30.4 0 3 t0.1317
1/54 depth 1: feed to 33 0 3 F100 t1.56
1/55 depth 1: feed to 33 0 -27.3593 F100 t18.2156
1/56 depth 1: feed to 32.4 0 -27.3593 F100 t0.36
1/57 depth 1: rapid to 32.4 0 3 t0.1214
1/58 depth 1: feed to 35 0 3 F100 t1.56
1/59 depth 1: feed to 35 0 -24.7994 F100 t16.6796
1/60 depth 1: feed to 34.4 0 -24.7994 F100 t0.36
1/61 depth 1: rapid to 34.4 0 3 t0.1112
1/62 depth 1: feed to 37 0 3 F100 t1.56
1/63 depth 1: feed to 37 0 -22.2395 F100 t15.1437
1/64 depth 1: feed to 36.4 0 -22.2395 F100 t0.36
1/65 depth 1: rapid to 36.4 0 3 t0.101
1/66 depth 1: feed to 39 0 3 F100 t1.56
1/67 depth 1: feed to 39 0 -19.6796 F100 t13.6078
1/68 depth 1: feed to 38.4 0 -19.6796 F100 t0.36
1/69 depth 1: rapid to 38.4 0 3 t0.0907
1/70 depth 1: feed to 41 0 3 F100 t1.56
1/71 depth 1: feed to 41 0 -17.1198 F100 t12.0719
1/72 depth 1: feed to 40.4 0 -17.1198 F100 t0.36
1/73 depth 1: rapid to 40.4 0 3 t0.0805
1/74 depth 1: feed to 43 0 3 F100 t1.56
1/75 depth 1: feed to 43 0 -14.5599 F100 t10.5359
1/76 depth 1: feed to 42.4 0 -14.5599 F100 t0.36
1/77 depth 1: rapid to 42.4 0 3 t0.0702
1/78 depth 1: feed to 45 0 3 F100 t1.56
1/79 depth 1: feed to 45 0 -12 F100 t9
1/80 depth 1: feed to 5 0 -63.1977 F100 t38.9825
1/81 depth 1: rapid to 5 0 3 t0.2648
5: rapid to 100 0 100 t0.388
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 82 motions, 0 errors, 0 warnings
