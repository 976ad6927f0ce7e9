=== about
Roughing of a shaft: G13.2A30Y30Z5R10G45P1C2B3V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.2-G13.2 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G13.2A30Y30Z5R10G45P1C2B3V0
G81X200Z100
M02
=== truth
42.857864 0 3
39.857864 0 3
39.857864 0 -34
40.257864 0 -34
40.257864 0 3
38.857864 0 3
38.857864 0 -33
39.257864 0 -33
39.257864 0 3
37.857864 0 3
37.857864 0 -32
38.257864 0 -32
38.257864 0 3
36.857864 0 3
36.857864 0 -31
37.257864 0 -31
37.257864 0 3
35.857864 0 3
35.857864 0 -30
36.257864 0 -30
36.257864 0 3
34.857864 0 3
34.857864 0 -29
35.257864 0 -29
35.257864 0 3
33.857864 0 3
33.857864 0 -28
34.257864 0 -28
34.257864 0 3
32.857864 0 3
32.857864 0 -27
33.257864 0 -27
33.257864 0 3
31.857864 0 3
31.857864 0 -26
32.257864 0 -26
32.257864 0 3
30.857864 0 3
30.857864 0 -25
31.257864 0 -25
31.257864 0 3
29.857864 0 3
29.857864 0 -24
30.257864 0 -24
30.257864 0 3
28.857864 0 3
28.857864 0 -23
29.257864 0 -23
29.257864 0 3
27.857864 0 3
27.857864 0 -22
28.257864 0 -22
28.257864 0 3
26.857864 0 3
26.857864 0 -21
27.257864 0 -21
27.257864 0 3
25.857864 0 3
25.857864 0 -20
26.257864 0 -20
26.257864 0 3
24.857864 0 3
24.857864 0 -19
25.257864 0 -19
25.257864 0 3
23.857864 0 3
23.857864 0 -18
24.257864 0 -18
24.257864 0 3
22.857864 0 3
22.857864 0 -17
23.257864 0 -17
23.257864 0 3
21.857864 0 3
21.857864 0 -16
22.257864 0 -16
22.257864 0 3
20.857864 0 3
20.857864 0 -15
21.257864 0 -15
21.257864 0 3
19.857864 0 3
19.857864 0 -14
20.257864 0 -14
20.257864 0 3
18.857864 0 3
18.857864 0 -13
19.257864 0 -13
19.257864 0 3
17.928932 0 3
17.928932 0 -12.071068
18.328932 0 -12.071068
18.328932 0 3
16.928932 0 3
16.928932 0 -10.904055
17.328932 0 -10.904055
17.328932 0 3
15.928932 0 3
15.928932 0 -9.209006
16.328932 0 -9.209006
16.328932 0 3
15 0 3
15 0 -5
17.928932 0 -12.071068 center 25 0 -5 sweep -45
40.857864 0 -35
42.857864 0 -35
42.857864 0 3
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G13.2 of line 4
1/1 depth 1: rapid from 100 0 50 to 42.8579 0 3 t0.2286
1/2 depth 1: feed to 39.8579 0 3 F100 t1.8
1/3 depth 1: feed to 39.8579 0 -34 F100 t22.2
1/4 depth 1: feed to 40.2579 0 -34 F100 t0.24
1/5 depth 1: rapid to 40.2579 0 3 t0.148
1/6 depth 1: feed to 38.8579 0 3 F100 t0.84
1/7 depth 1: feed to 38.8579 0 -33 F100 t21.6
1/8 depth 1: feed to 39.2579 0 -33 F100 t0.24
1/9 depth 1: rapid to 39.2579 0 3 t0.144
1/10 depth 1: feed to 37.8579 0 3 F100 t0.84
1/11 depth 1: feed to 37.8579 0 -32 F100 t21
1/12 depth 1: feed to 38.2579 0 -32 F100 t0.24
1/13 depth 1: rapid to 38.2579 0 3 t0.14
1/14 depth 1: feed to 36.8579 0 3 F100 t0.84
1/15 depth 1: feed to 36.8579 0 -31 F100 t20.4
1/16 depth 1: feed to 37.2579 0 -31 F100 t0.24
1/17 depth 1: rapid to 37.2579 0 3 t0.136
1/18 depth 1: feed to 35.8579 0 3 F100 t0.84
1/19 depth 1: feed to 35.8579 0 -30 F100 t19.8
1/20 depth 1: feed to 36.2579 0 -30 F100 t0.24
1/21 depth 1: rapid to 36.2579 0 3 t0.132
1/22 depth 1: feed to 34.8579 0 3 F100 t0.84
1/23 depth 1: feed to 34.8579 0 -29 F100 t19.2
1/24 depth 1: feed to 35.2579 0 -29 F100 t0.24
1/25 depth 1: rapid to 35.2579 0 3 t0.128
1/26 depth 1: feed to 33.8579 0 3 F100 t0.84
1/27 depth 1: feed to 33.8579 0 -28 F100 t18.6
1/28 depth 1: feed to 34.2579 0 -28 F100 t0.24
1/29 depth 1: rapid to 34.2579 0 3 t0.124
1/30 depth 1: feed to 32.8579 0 3 F100 t0.84
1/31 depth 1: feed to 32.8579 0 -27 F100 t18
1/32 depth 1: feed to 33.2579 0 -27 F100 t0.24
1/33 depth 1: rapid to 33.2579 0 3 t0.12
1/34 depth 1: feed to 31.8579 0 3 F100 t0.84
1/35 depth 1: feed to 31.8579 0 -26 F100 t17.4
1/36 depth 1: feed to 32.2579 0 -26 F100 t0.24
1/37 depth 1: rapid to 32.2579 0 3 t0.116
1/38 depth 1: feed to 30.8579 0 3 F100 t0.84
1/39 depth 1: feed to 30.8579 0 -25 F100 t16.8
1/40 depth 1: feed to 31.2579 0 -25 F100 t0.24
1/41 depth 1: rapid to 31.2579 0 3 t0.112
1/42 depth 1: feed to 29.8579 0 3 F100 t0.84
1/43 depth 1: feed to 29.8579 0 -24 F100 t16.2
1/44 depth 1: feed to 30.2579 0 -24 F100 t0.24
1/45 depth 1: rapid to 30.2579 0 3 t0.108
1/46 depth 1: feed to 28.8579 0 3 F100 t0.84
1/47 depth 1: feed to 28.8579 0 -23 F100 t15.6
1/48 depth 1: feed to 29.2579 0 -23 F100 t0.24
1/49 depth 1: rapid to 29.2579 0 3 t0.104
1/50 depth 1: feed to 27.8579 0 3 F100 t0.84
1/51 depth 1: feed to 27.8579 0 -22 F100 t15
1/52 depth 1: feed to 28.2579 0 -22 F100 t0.24
1/53 depth 1: rapid to 28.2579 0 3 t0.1
1/54 depth 1: feed to 26.8579 0 3 F100 t0.84
1/55 depth 1: feed to 26.8579 0 -21 F100 t14.4
1/56 depth 1: feed to 27.2579 0 -21 F100 t0.24
1/57 depth 1: rapid to 27.2579 0 3 t0.096
1/58 depth 1: feed to 25.8579 0 3 F100 t0.84
1/59 depth 1: feed to 25.8579 0 -20 F100 t13.8
1/60 depth 1: feed to 26.2579 0 -20 F100 t0.24
1/61 depth 1: rapid to 26.2579 0 3 t0.092
1/62 depth 1: feed to 24.8579 0 3 F100 t0.84
1/63 depth 1: feed to 24.8579 0 -19 F100 t13.2
1/64 depth 1: feed to 25.2579 0 -19 F100 t0.24
1/65 depth 1: rapid to 25.2579 0 3 t0.088
1/66 depth 1: feed to 23.8579 0 3 F100 t0.84
1/67 depth 1: feed to 23.8579 0 -18 F100 t12.6
1/68 depth 1: feed to 24.2579 0 -18 F100 t0.24
1/69 depth 1: rapid to 24.2579 0 3 t0.084
1/70 depth 1: feed to 22.8579 0 3 F100 t0.84
1/71 depth 1: feed to 22.8579 0 -17 F100 t12
1/72 depth 1: feed to 23.2579 0 -17 F100 t0.24
1/73 depth 1: rapid to 23.2579 0 3 t0.08
1/74 depth 1: feed to 21.8579 0 3 F100 t0.84
1/75 depth 1: feed to 21.8579 0 -16 F100 t11.4
1/76 depth 1: feed to 22.2579 0 -16 F100 t0.24
1/77 depth 1: rapid to 22.2579 0 3 t0.076
1/78 depth 1: feed to 20.8579 0 3 F100 t0.84
1/79 depth 1: feed to 20.8579 0 -15 F100 t10.8
1/80 depth 1: feed to 21.2579 0 -15 F100 t0.24
1/81 depth 1: rapid to 21.2579 0 3 t0.072
1/82 depth 1: feed to 19.8579 0 3 F100 t0.84
1/83 depth 1: feed to 19.8579 0 -14 F100 t10.2
1/84 depth 1: feed to 20.2579 0 -14 F100 t0.24
1/85 depth 1: rapid to 20.2579 0 3 t0.068
1/86 depth 1: feed to 18.8579 0 3 F100 t0.84
1/87 depth 1: feed to 18.8579 0 -13 F100 t9.6
1/88 depth 1: feed to 19.2579 0 -13 F100 t0.24
1/89 depth 1: rapid to 19.2579 0 3 t0.064
1/90 depth 1: feed to 17.9289 0 3 F100 t0.7974
1/91 depth 1: feed to 17.9289 0 -12.0711 F100 t9.0426
1/92 depth 1: feed to 18.3289 0 -12.0711 F100 t0.24
1/93 depth 1: rapid to 18.3289 0 3 t0.0603
1/94 depth 1: feed to 16.9289 0 3 F100 t0.84
1/95 depth 1: feed to 16.9289 0 -10.9041 F100 t8.3424
1/96 depth 1: feed to 17.3289 0 -10.9041 F100 t0.24
1/97 depth 1: rapid to 17.3289 0 3 t0.0556
1/98 depth 1: feed to 15.9289 0 3 F100 t0.84
1/99 depth 1: feed to 15.9289 0 -9.209 F100 t7.3254
1/100 depth 1: feed to 16.3289 0 -9.209 F100 t0.24
1/101 depth 1: rapid to 16.3289 0 3 t0.0488
1/102 depth 1: feed to 15 0 3 F100 t0.7974
1/103 depth 1: feed to 15 0 -5 F100 t4.8
1/104 depth 1: feed arc to 17.9289 0 -12.0711 center 25 0 -5 normal 0 1 0 sweep -45 F100 t4.7124
1/105 depth 1: feed to 40.8579 0 -35 F100 t19.4558
1/106 depth 1: rapid to 42.8579 0 -35 t0.008
1/107 depth 1: rapid to 42.8579 0 3 t0.152
5: rapid to 100 0 100 t0.388
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 108 motions, 0 errors, 0 warnings
