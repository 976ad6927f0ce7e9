=== about
Roughing of a hole: G12.1X20Y25R12Z0G45P1C-3B3V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.3-G12.1 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G12.1X20Y25R12Z0G45P1C-3B3V0
G81X200Z100
M02
=== truth
7 0 3
11 0 3
11 0 -24
10.4 0 -24
10.4 0 3
12 0 3
12 0 -23
11.4 0 -23
11.4 0 3
13 0 3
13 0 -22
12.4 0 -22
12.4 0 3
14 0 3
14 0 -21
13.4 0 -21
13.4 0 3
15 0 3
15 0 -20
14.4 0 -20
14.4 0 3
16 0 3
16 0 -19
15.4 0 -19
15.4 0 3
17 0 3
17 0 -18
16.4 0 -18
16.4 0 3
18 0 3
18 0 -17
17.4 0 -17
17.4 0 3
19 0 3
19 0 -16
18.4 0 -16
18.4 0 3
20 0 3
20 0 -15
19.4 0 -15
19.4 0 3
21 0 3
21 0 -14
20.4 0 -14
20.4 0 3
22 0 3
22 0 -13
21.4 0 -13
21.4 0 3
23 0 3
23 0 -12
22.4 0 -12
22.4 0 3
24 0 3
24 0 -11
23.4 0 -11
23.4 0 3
25 0 3
25 0 -10
24.4 0 -10
24.4 0 3
26 0 3
26 0 -9
25.4 0 -9
25.4 0 3
27 0 3
27 0 -8
26.4 0 -8
26.4 0 3
28 0 3
28 0 -7
27.4 0 -7
27.4 0 3
29 0 3
29 0 -6
28.4 0 -6
28.4 0 3
30 0 3
30 0 -5
29.4 0 -5
29.4 0 3
31 0 3
31 0 -4
30.4 0 -4
30.4 0 3
31.485281 0 3
31.485281 0 -3.514719
30.885281 0 -3.514719
30.885281 0 3
32.485281 0 3
32.485281 0 -2.620738
31.885281 0 -2.620738
31.885281 0 3
33.485281 0 3
33.485281 0 -1.90341
32.885281 0 -1.90341
32.885281 0 3
34.485281 0 3
34.485281 0 -1.327058
33.885281 0 -1.327058
33.885281 0 3
35.485281 0 3
35.485281 0 -0.86976
34.885281 0 -0.86976
34.885281 0 3
36.485281 0 3
36.485281 0 -0.517282
35.885281 0 -0.517282
35.885281 0 3
37.485281 0 3
37.485281 0 -0.26018
36.885281 0 -0.26018
36.885281 0 3
38.485281 0 3
38.485281 0 -0.092274
37.885281 0 -0.092274
37.885281 0 3
39.485281 0 3
39.485281 0 -0.009816
38.885281 0 -0.009816
38.885281 0 3
39.970563 0 3
39.970563 0 0
31.485281 0 -3.514719 center 39.970563 0 -12 sweep -45
10 0 -25
10 0 3
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G12.1 of line 4
1/1 depth 1: rapid from 100 0 50 to 7 0 3 t0.372
1/2 depth 1: feed to 11 0 3 F100 t2.4
1/3 depth 1: feed to 11 0 -24 F100 t16.2
1/4 depth 1: feed to 10.4 0 -24 F100 t0.36
1/5 depth 1: rapid to 10.4 0 3 t0.108
1/6 depth 1: feed to 12 0 3 F100 t0.96
1/7 depth 1: feed to 12 0 -23 F100 t15.6
1/8 depth 1: feed to 11.4 0 -23 F100 t0.36
1/9 depth 1: rapid to 11.4 0 3 t0.104
1/10 depth 1: feed to 13 0 3 F100 t0.96
1/11 depth 1: feed to 13 0 -22 F100 t15
1/12 depth 1: feed to 12.4 0 -22 F100 t0.36
1/13 depth 1: rapid to 12.4 0 3 t0.1
1/14 depth 1: feed to 14 0 3 F100 t0.96
1/15 depth 1: feed to 14 0 -21 F100 t14.4
1/16 depth 1: feed to 13.4 0 -21 F100 t0.36
1/17 depth 1: rapid to 13.4 0 3 t0.096
1/18 depth 1: feed to 15 0 3 F100 t0.96
1/19 depth 1: feed to 15 0 -20 F100 t13.8
1/20 depth 1: feed to 14.4 0 -20 F100 t0.36
1/21 depth 1: rapid to 14.4 0 3 t0.092
1/22 depth 1: feed to 16 0 3 F100 t0.96
1/23 depth 1: feed to 16 0 -19 F100 t13.2
1/24 depth 1: feed to 15.4 0 -19 F100 t0.36
1/25 depth 1: rapid to 15.4 0 3 t0.088
1/26 depth 1: feed to 17 0 3 F100 t0.96
1/27 depth 1: feed to 17 0 -18 F100 t12.6
1/28 depth 1: feed to 16.4 0 -18 F100 t0.36
1/29 depth 1: rapid to 16.4 0 3 t0.084
1/30 depth 1: feed to 18 0 3 F100 t0.96
1/31 depth 1: feed to 18 0 -17 F100 t12
1/32 depth 1: feed to 17.4 0 -17 F100 t0.36
1/33 depth 1: rapid to 17.4 0 3 t0.08
1/34 depth 1: feed to 19 0 3 F100 t0.96
1/35 depth 1: feed to 19 0 -16 F100 t11.4
1/36 depth 1: feed to 18.4 0 -16 F100 t0.36
1/37 depth 1: rapid to 18.4 0 3 t0.076
1/38 depth 1: feed to 20 0 3 F100 t0.96
1/39 depth 1: feed to 20 0 -15 F100 t10.8
1/40 depth 1: feed to 19.4 0 -15 F100 t0.36
1/41 depth 1: rapid to 19.4 0 3 t0.072
1/42 depth 1: feed to 21 0 3 F100 t0.96
1/43 depth 1: feed to 21 0 -14 F100 t10.2
1/44 depth 1: feed to 20.4 0 -14 F100 t0.36
1/45 depth 1: rapid to 20.4 0 3 t0.068
1/46 depth 1: feed to 22 0 3 F100 t0.96
1/47 depth 1: feed to 22 0 -13 F100 t9.6
1/48 depth 1: feed to 21.4 0 -13 F100 t0.36
1/49 depth 1: rapid to 21.4 0 3 t0.064
1/50 depth 1: feed to 23 0 3 F100 t0.96
1/51 depth 1: feed to 23 0 -12 F100 t9
1/52 depth 1: feed to 22.4 0 -12 F100 t0.36
1/53 depth 1: rapid to 22.4 0 3 t0.06
1/54 depth 1: feed to 24 0 3 F100 t0.96
1/55 depth 1: feed to 24 0 -11 F100 t8.4
1/56 depth 1: feed to 23.4 0 -11 F100 t0.36
1/57 depth 1: rapid to 23.4 0 3 t0.056
1/58 depth 1: feed to 25 0 3 F100 t0.96
1/59 depth 1: feed to 25 0 -10 F100 t7.8
1/60 depth 1: feed to 24.4 0 -10 F100 t0.36
1/61 depth 1: rapid to 24.4 0 3 t0.052
1/62 depth 1: feed to 26 0 3 F100 t0.96
1/63 depth 1: feed to 26 0 -9 F100 t7.2
1/64 depth 1: feed to 25.4 0 -9 F100 t0.36
1/65 depth 1: rapid to 25.4 0 3 t0.048
1/66 depth 1: feed to 27 0 3 F100 t0.96
1/67 depth 1: feed to 27 0 -8 F100 t6.6
1/68 depth 1: feed to 26.4 0 -8 F100 t0.36
1/69 depth 1: rapid to 26.4 0 3 t0.044
1/70 depth 1: feed to 28 0 3 F100 t0.96
1/71 depth 1: feed to 28 0 -7 F100 t6
1/72 depth 1: feed to 27.4 0 -7 F100 t0.36
1/73 depth 1: rapid to 27.4 0 3 t0.04
1/74 depth 1: feed to 29 0 3 F100 t0.96
1/75 depth 1: feed to 29 0 -6 F100 t5.4
1/76 depth 1: feed to 28.4 0 -6 F100 t0.36
1/77 depth 1: rapid to 28.4 0 3 t0.036
1/78 depth 1: feed to 30 0 3 F100 t0.96
1/79 depth 1: feed to 30 0 -5 F100 t4.8
1/80 depth 1: feed to 29.4 0 -5 F100 t0.36
1/81 depth 1: rapid to 29.4 0 3 t0.032
1/82 depth 1: feed to 31 0 3 F100 t0.96
1/83 depth 1: feed to 31 0 -4 F100 t4.2
1/84 depth 1: feed to 30.4 0 -4 F100 t0.36
1/85 depth 1: rapid to 30.4 0 3 t0.028
1/86 depth 1: feed to 31.4853 0 3 F100 t0.6512
1/87 depth 1: feed to 31.4853 0 -3.5147 F100 t3.9088
1/88 depth 1: feed to 30.8853 0 -3.5147 F100 t0.36
1/89 depth 1: rapid to 30.8853 0 3 t0.0261
1/90 depth 1: feed to 32.4853 0 3 F100 t0.96
1/91 depth 1: feed to 32.4853 0 -2.6207 F100 t3.3724
1/92 depth 1: feed to 31.8853 0 -2.6207 F100 t0.36
1/93 depth 1: rapid to 31.8853 0 3 t0.0225
1/94 depth 1: feed to 33.4853 0 3 F100 t0.96
1/95 depth 1: feed to 33.4853 0 -1.9034 F100 t2.942
1/96 depth 1: feed to 32.8853 0 -1.9034 F100 t0.36
1/97 depth 1: rapid to 32.8853 0 3 t0.0196
1/98 depth 1: feed to 34.4853 0 3 F100 t0.96
1/99 depth 1: feed to 34.4853 0 -1.3271 F100 t2.5962
1/100 depth 1: feed to 33.8853 0 -1.3271 F100 t0.36
1/101 depth 1: rapid to 33.8853 0 3 t0.0173
1/102 depth 1: feed to 35.4853 0 3 F100 t0.96
1/103 depth 1: feed to 35.4853 0 -0.8698 F100 t2.3219
1/104 depth 1: feed to 34.8853 0 -0.8698 F100 t0.36
1/105 depth 1: rapid to 34.8853 0 3 t0.0155
1/106 depth 1: feed to 36.4853 0 3 F100 t0.96
1/107 depth 1: feed to 36.4853 0 -0.5173 F100 t2.1104
1/108 depth 1: feed to 35.8853 0 -0.5173 F100 t0.36
1/109 depth 1: rapid to 35.8853 0 3 t0.0141
1/110 depth 1: feed to 37.4853 0 3 F100 t0.96
1/111 depth 1: feed to 37.4853 0 -0.2602 F100 t1.9561
1/112 depth 1: feed to 36.8853 0 -0.2602 F100 t0.36
1/113 depth 1: rapid to 36.8853 0 3 t0.013
1/114 depth 1: feed to 38.4853 0 3 F100 t0.96
1/115 depth 1: feed to 38.4853 0 -0.0923 F100 t1.8554
1/116 depth 1: feed to 37.8853 0 -0.0923 F100 t0.36
1/117 depth 1: rapid to 37.8853 0 3 t0.0124
1/118 depth 1: feed to 39.4853 0 3 F100 t0.96
1/119 depth 1: feed to 39.4853 0 -0.0098 F100 t1.8059
1/120 depth 1: feed to 38.8853 0 -0.0098 F100 t0.36
1/121 depth 1: rapid to 38.8853 0 3 t0.012
1/122 depth 1: feed to 39.9706 0 3 F100 t0.6512
1/123 depth 1: feed to 39.9706 0 0 F100 t1.8
1/124 depth 1: feed arc to 31.4853 0 -3.5147 center 39.9706 0 -12 normal 0 1 0 sweep -45 F100 t5.6549
1/125 depth 1: feed to 10 0 -25 F100 t18.2309
1/126 depth 1: rapid to 10 0 3 t0.112
5: rapid to 100 0 100 t0.388
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 127 motions, 0 errors, 0 warnings
