=== about
Roughing of a shaft: G12.3A20Y30Z5R10G45P1C2B3V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.2-G12.3 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G12.3A20Y30Z5R10G45P1C2B3V0
G81X200Z100
M02
=== truth
42 0 3
39 0 3
39 0 -34
39.4 0 -34
39.4 0 3
38 0 3
38 0 -33
38.4 0 -33
38.4 0 3
37 0 3
37 0 -32
37.4 0 -32
37.4 0 3
36 0 3
36 0 -31
36.4 0 -31
36.4 0 3
35 0 3
35 0 -30
35.4 0 -30
35.4 0 3
34 0 3
34 0 -29
34.4 0 -29
34.4 0 3
33 0 3
33 0 -28
33.4 0 -28
33.4 0 3
32 0 3
32 0 -27
32.4 0 -27
32.4 0 3
31 0 3
31 0 -26
31.4 0 -26
31.4 0 3
30 0 3
30 0 -25
30.4 0 -25
30.4 0 3
29 0 3
29 0 -24
29.4 0 -24
29.4 0 3
28 0 3
28 0 -23
28.4 0 -23
28.4 0 3
27 0 3
27 0 -22
27.4 0 -22
27.4 0 3
26 0 3
26 0 -21
26.4 0 -21
26.4 0 3
25 0 3
25 0 -20
25.4 0 -20
25.4 0 3
24 0 3
24 0 -19
24.4 0 -19
24.4 0 3
23 0 3
23 0 -18
23.4 0 -18
23.4 0 3
22 0 3
22 0 -17
22.4 0 -17
22.4 0 3
21 0 3
21 0 -16
21.4 0 -16
21.4 0 3
20 0 3
20 0 -15
20.4 0 -15
20.4 0 3
19 0 3
19 0 -14
19.4 0 -14
19.4 0 3
18 0 3
18 0 -13
18.4 0 -13
18.4 0 3
17 0 3
17 0 -12
17.4 0 -12
17.4 0 3
16 0 3
16 0 -11
16.4 0 -11
16.4 0 3
15 0 3
15 0 -10
15.4 0 -10
15.4 0 3
14 0 3
14 0 -9
14.4 0 -9
14.4 0 3
13 0 3
13 0 -8
13.4 0 -8
13.4 0 3
12.928932 0 3
12.928932 0 -7.928932
13.328932 0 -7.928932
13.328932 0 3
11.928932 0 3
11.928932 0 -7.053797
12.328932 0 -7.053797
12.328932 0 3
10.928932 0 3
10.928932 0 -6.381168
11.328932 0 -6.381168
11.328932 0 3
9.928932 0 3
9.928932 0 -5.866194
10.328932 0 -5.866194
10.328932 0 3
8.928932 0 3
8.928932 0 -5.483249
9.328932 0 -5.483249
9.328932 0 3
7.928932 0 3
7.928932 0 -5.216817
8.328932 0 -5.216817
8.328932 0 3
6.928932 0 3
6.928932 0 -5.057525
7.328932 0 -5.057525
7.328932 0 3
5.928932 0 3
5.928932 0 -5.000253
6.328932 0 -5.000253
6.328932 0 3
5.857864 0 3
5.857864 0 -5
12.928932 0 -7.928932 center 5.857864 0 -15 sweep 45
40 0 -35
42 0 -35
42 0 3
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G12.3 of line 4
1/1 depth 1: rapid from 100 0 50 to 42 0 3 t0.232
1/2 depth 1: feed to 39 0 3 F100 t1.8
1/3 depth 1: feed to 39 0 -34 F100 t22.2
1/4 depth 1: feed to 39.4 0 -34 F100 t0.24
1/5 depth 1: rapid to 39.4 0 3 t0.148
1/6 depth 1: feed to 38 0 3 F100 t0.84
1/7 depth 1: feed to 38 0 -33 F100 t21.6
1/8 depth 1: feed to 38.4 0 -33 F100 t0.24
1/9 depth 1: rapid to 38.4 0 3 t0.144
1/10 depth 1: feed to 37 0 3 F100 t0.84
1/11 depth 1: feed to 37 0 -32 F100 t21
1/12 depth 1: feed to 37.4 0 -32 F100 t0.24
1/13 depth 1: rapid to 37.4 0 3 t0.14
1/14 depth 1: feed to 36 0 3 F100 t0.84
1/15 depth 1: feed to 36 0 -31 F100 t20.4
1/16 depth 1: feed to 36.4 0 -31 F100 t0.24
1/17 depth 1: rapid to 36.4 0 3 t0.136
1/18 depth 1: feed to 35 0 3 F100 t0.84
1/19 depth 1: feed to 35 0 -30 F100 t19.8
1/20 depth 1: feed to 35.4 0 -30 F100 t0.24
1/21 depth 1: rapid to 35.4 0 3 t0.132
1/22 depth 1: feed to 34 0 3 F100 t0.84
1/23 depth 1: feed to 34 0 -29 F100 t19.2
1/24 depth 1: feed to 34.4 0 -29 F100 t0.24
1/25 depth 1: rapid to 34.4 0 3 t0.128
1/26 depth 1: feed to 33 0 3 F100 t0.84
1/27 depth 1: feed to 33 0 -28 F100 t18.6
1/28 depth 1: feed to 33.4 0 -28 F100 t0.24
1/29 depth 1: rapid to 33.4 0 3 t0.124
1/30 depth 1: feed to 32 0 3 F100 t0.84
1/31 depth 1: feed to 32 0 -27 F100 t18
1/32 depth 1: feed to 32.4 0 -27 F100 t0.24
1/33 depth 1: rapid to 32.4 0 3 t0.12
1/34 depth 1: feed to 31 0 3 F100 t0.84
1/35 depth 1: feed to 31 0 -26 F100 t17.4
1/36 depth 1: feed to 31.4 0 -26 F100 t0.24
1/37 depth 1: rapid to 31.4 0 3 t0.116
1/38 depth 1: feed to 30 0 3 F100 t0.84
1/39 depth 1: feed to 30 0 -25 F100 t16.8
1/40 depth 1: feed to 30.4 0 -25 F100 t0.24
1/41 depth 1: rapid to 30.4 0 3 t0.112
1/42 depth 1: feed to 29 0 3 F100 t0.84
1/43 depth 1: feed to 29 0 -24 F100 t16.2
1/44 depth 1: feed to 29.4 0 -24 F100 t0.24
1/45 depth 1: rapid to 29.4 0 3 t0.108
1/46 depth 1: feed to 28 0 3 F100 t0.84
1/47 depth 1: feed to 28 0 -23 F100 t15.6
1/48 depth 1: feed to 28.4 0 -23 F100 t0.24
1/49 depth 1: rapid to 28.4 0 3 t0.104
1/50 depth 1: feed to 27 0 3 F100 t0.84
1/51 depth 1: feed to 27 0 -22 F100 t15
1/52 depth 1: feed to 27.4 0 -22 F100 t0.24
1/53 depth 1: rapid to 27.4 0 3 t0.1
1/54 depth 1: feed to 26 0 3 F100 t0.84
1/55 depth 1: feed to 26 0 -21 F100 t14.4
1/56 depth 1: feed to 26.4 0 -21 F100 t0.24
1/57 depth 1: rapid to 26.4 0 3 t0.096
1/58 depth 1: feed to 25 0 3 F100 t0.84
1/59 depth 1: feed to 25 0 -20 F100 t13.8
1/60 depth 1: feed to 25.4 0 -20 F100 t0.24
1/61 depth 1: rapid to 25.4 0 3 t0.092
1/62 depth 1: feed to 24 0 3 F100 t0.84
1/63 depth 1: feed to 24 0 -19 F100 t13.2
1/64 depth 1: feed to 24.4 0 -19 F100 t0.24
1/65 depth 1: rapid to 24.4 0 3 t0.088
1/66 depth 1: feed to 23 0 3 F100 t0.84
1/67 depth 1: feed to 23 0 -18 F100 t12.6
1/68 depth 1: feed to 23.4 0 -18 F100 t0.24
1/69 depth 1: rapid to 23.4 0 3 t0.084
1/70 depth 1: feed to 22 0 3 F100 t0.84
1/71 depth 1: feed to 22 0 -17 F100 t12
1/72 depth 1: feed to 22.4 0 -17 F100 t0.24
1/73 depth 1: rapid to 22.4 0 3 t0.08
1/74 depth 1: feed to 21 0 3 F100 t0.84
1/75 depth 1: feed to 21 0 -16 F100 t11.4
1/76 depth 1: feed to 21.4 0 -16 F100 t0.24
1/77 depth 1: rapid to 21.4 0 3 t0.076
1/78 depth 1: feed to 20 0 3 F100 t0.84
1/79 depth 1: feed to 20 0 -15 F100 t10.8
1/80 depth 1: feed to 20.4 0 -15 F100 t0.24
1/81 depth 1: rapid to 20.4 0 3 t0.072
1/82 depth 1: feed to 19 0 3 F100 t0.84
1/83 depth 1: feed to 19 0 -14 F100 t10.2
1/84 depth 1: feed to 19.4 0 -14 F100 t0.24
1/85 depth 1: rapid to 19.4 0 3 t0.068
1/86 depth 1: feed to 18 0 3 F100 t0.84
1/87 depth 1: feed to 18 0 -13 F100 t9.6
1/88 depth 1: feed to 18.4 0 -13 F100 t0.24
1/89 depth 1: rapid to 18.4 0 3 t0.064
1/90 depth 1: feed to 17 0 3 F100 t0.84
1/91 depth 1: feed to 17 0 -12 F100 t9
1/92 depth 1: feed to 17.4 0 -12 F100 t0.24
1/93 depth 1: rapid to 17.4 0 3 t0.06
1/94 depth 1: feed to 16 0 3 F100 t0.84
1/95 depth 1: feed to 16 0 -11 F100 t8.4
1/96 depth 1: feed to 16.4 0 -11 F100 t0.24
1/97 depth 1: rapid to 16.4 0 3 t0.056
1/98 depth 1: feed to 15 0 3 F100 t0.84
1/99 depth 1: feed to 15 0 -10 F100 t7.8
1/100 depth 1: feed to 15.4 0 -10 F100 t0.24
1/101 depth 1: rapid to 15.4 0 3 t0.052
1/102 depth 1: feed to 14 0 3 F100 t0.84
1/103 depth 1: feed to 14 0 -9 F100 t7.2
1/104 depth 1: feed to 14.4 0 -9 F100 t0.24
1/105 depth 1: rapid to 14.4 0 3 t0.048
1/106 depth 1: feed to 13 0 3 F100 t0.84
1/107 depth 1: feed to 13 0 -8 F100 t6.6
1/108 depth 1: feed to 13.4 0 -8 F100 t0.24
1/109 depth 1: rapid to 13.4 0 3 t0.044
1/110 depth 1: feed to 12.9289 0 3 F100 t0.2826
1/111 depth 1: feed to 12.9289 0 -7.9289 F100 t6.5574
1/112 depth 1: feed to 13.3289 0 -7.9289 F100 t0.24
1/113 depth 1: rapid to 13.3289 0 3 t0.0437
1/114 depth 1: feed to 11.9289 0 3 F100 t0.84
1/115 depth 1: feed to 11.9289 0 -7.0538 F100 t6.0323
1/116 depth 1: feed to 12.3289 0 -7.0538 F100 t0.24
1/117 depth 1: rapid to 12.3289 0 3 t0.0402
1/118 depth 1: feed to 10.9289 0 3 F100 t0.84
1/119 depth 1: feed to 10.9289 0 -6.3812 F100 t5.6287
1/120 depth 1: feed to 11.3289 0 -6.3812 F100 t0.24
1/121 depth 1: rapid to 11.3289 0 3 t0.0375
1/122 depth 1: feed to 9.9289 0 3 F100 t0.84
1/123 depth 1: feed to 9.9289 0 -5.8662 F100 t5.3197
1/124 depth 1: feed to 10.3289 0 -5.8662 F100 t0.24
1/125 depth 1: rapid to 10.3289 0 3 t0.0355
1/126 depth 1: feed to 8.9289 0 3 F100 t0.84
1/127 depth 1: feed to 8.9289 0 -5.4832 F100 t5.0899
1/128 depth 1: feed to 9.3289 0 -5.4832 F100 t0.24
1/129 depth 1: rapid to 9.3289 0 3 t0.0339
1/130 depth 1: feed to 7.9289 0 3 F100 t0.84
1/131 depth 1: feed to 7.9289 0 -5.2168 F100 t4.9301
1/132 depth 1: feed to 8.3289 0 -5.2168 F100 t0.24
1/133 depth 1: rapid to 8.3289 0 3 t0.0329
1/134 depth 1: feed to 6.9289 0 3 F100 t0.84
1/135 depth 1: feed to 6.9289 0 -5.0575 F100 t4.8345
1/136 depth 1: feed to 7.3289 0 -5.0575 F100 t0.24
1/137 depth 1: rapid to 7.3289 0 3 t0.0322
1/138 depth 1: feed to 5.9289 0 3 F100 t0.84
1/139 depth 1: feed to 5.9289 0 -5.0003 F100 t4.8002
1/140 depth 1: feed to 6.3289 0 -5.0003 F100 t0.24
1/141 depth 1: rapid to 6.3289 0 3 t0.032
1/142 depth 1: feed to 5.8579 0 3 F100 t0.2826
1/143 depth 1: feed to 5.8579 0 -5 F100 t4.8
1/144 depth 1: feed arc to 12.9289 0 -7.9289 center 5.8579 0 -15 normal 0 1 0 sweep 45 F100 t4.7124
1/145 depth 1: feed to 40 0 -35 F100 t22.9706
1/146 depth 1: rapid to 42 0 -35 t0.008
1/147 depth 1: rapid to 42 0 3 t0.152
5: rapid to 100 0 100 t0.388
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 148 motions, 0 errors, 0 warnings
