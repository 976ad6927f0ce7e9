=== about
Roughing of a shaft: G8.1X100A0Z0R25U25P2C3B2V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.2-G8.1 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G8.1X100A0Z0R25U25P2C3B2V0
G81X200Z100
M02
=== truth
53 0 2
48 0 2
48 0 -49.919872
48.6 0 -49.919872
48.6 0 2
46 0 2
46 0 -49.677925
46.6 0 -49.677925
46.6 0 2
44 0 2
44 0 -49.269322
44.6 0 -49.269322
44.6 0 2
42 0 2
42 0 -48.685439
42.6 0 -48.685439
42.6 0 2
40 0 2
40 0 -47.912878
40.6 0 -47.912878
40.6 0 2
38 0 2
38 0 -46.931712
38.6 0 -46.931712
38.6 0 2
36 0 2
36 0 -45.712315
36.6 0 -45.712315
36.6 0 2
34 0 2
34 0 -44.209373
34.6 0 -44.209373
34.6 0 2
32 0 2
32 0 -42.349352
32.6 0 -42.349352
32.6 0 2
30 0 2
30 0 -40
30.6 0 -40
30.6 0 2
28 0 2
28 0 -36.874342
28.6 0 -36.874342
28.6 0 2
26 0 2
26 0 -32
26.6 0 -32
26.6 0 2
25 0 2
25 0 -25
25.6 0 -25
25.6 0 2
23 0 2
23 0 -15.202041
23.6 0 -15.202041
23.6 0 2
21 0 2
21 0 -11.43534
21.6 0 -11.43534
21.6 0 2
19 0 2
19 0 -8.751923
19.6 0 -8.751923
19.6 0 2
17 0 2
17 0 -6.669697
17.6 0 -6.669697
17.6 0 2
15 0 2
15 0 -5
15.6 0 -5
15.6 0 2
13 0 2
13 0 -3.645843
13.6 0 -3.645843
13.6 0 2
11 0 2
11 0 -2.550056
11.6 0 -2.550056
11.6 0 2
9 0 2
9 0 -1.676192
9.6 0 -1.676192
9.6 0 2
7 0 2
7 0 -1
7.6 0 -1
7.6 0 2
5 0 2
5 0 -0.505103
5.6 0 -0.505103
5.6 0 2
3 0 2
3 0 -0.180653
3.6 0 -0.180653
3.6 0 2
1 0 2
1 0 -0.020008
1.6 0 -0.020008
1.6 0 2
0 0 2
0 0 0
25 0 -25 center 0 0 -25 sweep 90
50 0 -50 center 50 0 -25 sweep -90
53 0 -50
53 0 2
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G8.1 of line 4
1/1 depth 1: rapid from 100 0 50 to 53 0 2 t0.192
1/2 depth 1: feed to 48 0 2 F100 t3
1/3 depth 1: feed to 48 0 -49.9199 F100 t31.1519
1/4 depth 1: feed to 48.6 0 -49.9199 F100 t0.36
1/5 depth 1: rapid to 48.6 0 2 t0.2077
1/6 depth 1: feed to 46 0 2 F100 t1.56
1/7 depth 1: feed to 46 0 -49.6779 F100 t31.0068
1/8 depth 1: feed to 46.6 0 -49.6779 F100 t0.36
1/9 depth 1: rapid to 46.6 0 2 t0.2067
1/10 depth 1: feed to 44 0 2 F100 t1.56
1/11 depth 1: feed to 44 0 -49.2693 F100 t30.7616
1/12 depth 1: feed to 44.6 0 -49.2693 F100 t0.36
1/13 depth 1: rapid to 44.6 0 2 t0.2051
1/14 depth 1: feed to 42 0 2 F100 t1.56
1/15 depth 1: feed to 42 0 -48.6854 F100 t30.4113
1/16 depth 1: feed to 42.6 0 -48.6854 F100 t0.36
1/17 depth 1: rapid to 42.6 0 2 t0.2027
1/18 depth 1: feed to 40 0 2 F100 t1.56
1/19 depth 1: feed to 40 0 -47.9129 F100 t29.9477
1/20 depth 1: feed to 40.6 0 -47.9129 F100 t0.36
1/21 depth 1: rapid to 40.6 0 2 t0.1997
1/22 depth 1: feed to 38 0 2 F100 t1.56
1/23 depth 1: feed to 38 0 -46.9317 F100 t29.359
1/24 depth 1: feed to 38.6 0 -46.9317 F100 t0.36
1/25 depth 1: rapid to 38.6 0 2 t0.1957
1/26 depth 1: feed to 36 0 2 F100 t1.56
1/27 depth 1: feed to 36 0 -45.7123 F100 t28.6274
1/28 depth 1: feed to 36.6 0 -45.7123 F100 t0.36
1/29 depth 1: rapid to 36.6 0 2 t0.1908
1/30 depth 1: feed to 34 0 2 F100 t1.56
1/31 depth 1: feed to 34 0 -44.2094 F100 t27.7256
1/32 depth 1: feed to 34.6 0 -44.2094 F100 t0.36
1/33 depth 1: rapid to 34.6 0 2 t0.1848
1/34 depth 1: feed to 32 0 2 F100 t1.56
1/35 depth 1: feed to 32 0 -42.3494 F100 t26.6096
1/36 depth 1: feed to 32.6 0 -42.3494 F100 t0.36
1/37 depth 1: rapid to 32.6 0 2 t0.1774
1/38 depth 1: feed to 30 0 2 F100 t1.56
1/39 depth 1: feed to 30 0 -40 F100 t25.2
1/40 depth 1: feed to 30.6 0 -40 F100 t0.36
1/41 depth 1: rapid to 30.6 0 2 t0.168
1/42 depth 1: feed to 28 0 2 F100 t1.56
1/43 depth 1: feed to 28 0 -36.8743 F100 t23.3246
1/44 depth 1: feed to 28.6 0 -36.8743 F100 t0.36
1/45 depth 1: rapid to 28.6 0 2 t0.1555
1/46 depth 1: feed to 26 0 2 F100 t1.56
1/47 depth 1: feed to 26 0 -32 F100 t20.4
1/48 depth 1: feed to 26.6 0 -32 F100 t0.36
1/49 depth 1: rapid to 26.6 0 2 t0.136
1/50 depth 1: feed to 25 0 2 F100 t0.96
1/51 depth 1: feed to 25 0 -25 F100 t16.2
1/52 depth 1: feed to 25.6 0 -25 F100 t0.36
1/53 depth 1: rapid to 25.6 0 2 t0.108
1/54 depth 1: feed to 23 0 2 F100 t1.56
1/55 depth 1: feed to 23 0 -15.202 F100 t10.3212
1/56 depth 1: feed to 23.6 0 -15.202 F100 t0.36
1/57 depth 1: rapid to 23.6 0 2 t0.0688
1/58 depth 1: feed to 21 0 2 F100 t1.56
1/59 depth 1: feed to 21 0 -11.4353 F100 t8.0612
1/60 depth 1: feed to 21.6 0 -11.4353 F100 t0.36
1/61 depth 1: rapid to 21.6 0 2 t0.0537
1/62 depth 1: feed to 19 0 2 F100 t1.56
1/63 depth 1: feed to 19 0 -8.7519 F100 t6.4512
1/64 depth 1: feed to 19.6 0 -8.7519 F100 t0.36
1/65 depth 1: rapid to 19.6 0 2 t0.043
1/66 depth 1: feed to 17 0 2 F100 t1.56
1/67 depth 1: feed to 17 0 -6.6697 F100 t5.2018
1/68 depth 1: feed to 17.6 0 -6.6697 F100 t0.36
1/69 depth 1: rapid to 17.6 0 2 t0.0347
1/70 depth 1: feed to 15 0 2 F100 t1.56
1/71 depth 1: feed to 15 0 -5 F100 t4.2
1/72 depth 1: feed to 15.6 0 -5 F100 t0.36
1/73 depth 1: rapid to 15.6 0 2 t0.028
1/74 depth 1: feed to 13 0 2 F100 t1.56
1/75 depth 1: feed to 13 0 -3.6458 F100 t3.3875
1/76 depth 1: feed to 13.6 0 -3.6458 F100 t0.36
1/77 depth 1: rapid to 13.6 0 2 t0.0226
1/78 depth 1: feed to 11 0 2 F100 t1.56
1/79 depth 1: feed to 11 0 -2.5501 F100 t2.73
1/80 depth 1: feed to 11.6 0 -2.5501 F100 t0.36
1/81 depth 1: rapid to 11.6 0 2 t0.0182
1/82 depth 1: feed to 9 0 2 F100 t1.56
1/83 depth 1: feed to 9 0 -1.6762 F100 t2.2057
1/84 depth 1: feed to 9.6 0 -1.6762 F100 t0.36
1/85 depth 1: rapid to 9.6 0 2 t0.0147
1/86 depth 1: feed to 7 0 2 F100 t1.56
1/87 depth 1: feed to 7 0 -1 F100 t1.8
1/88 depth 1: feed to 7.6 0 -1 F100 t0.36
1/89 depth 1: rapid to 7.6 0 2 t0.012
1/90 depth 1: feed to 5 0 2 F100 t1.56
1/91 depth 1: feed to 5 0 -0.5051 F100 t1.5031
1/92 depth 1: feed to 5.6 0 -0.5051 F100 t0.36
1/93 depth 1: rapid to 5.6 0 2 t0.01
1/94 depth 1: feed to 3 0 2 F100 t1.56
1/95 depth 1: feed to 3 0 -0.1807 F100 t1.3084
1/96 depth 1: feed to 3.6 0 -0.1807 F100 t0.36
1/97 depth 1: rapid to 3.6 0 2 t0.0087
1/98 depth 1: feed to 1 0 2 F100 t1.56
1/99 depth 1: feed to 1 0 -0.02 F100 t1.212
1/100 depth 1: feed to 1.6 0 -0.02 F100 t0.36
1/101 depth 1: rapid to 1.6 0 2 t0.0081
1/102 depth 1: feed to 0 0 2 F100 t0.96
1/103 depth 1: feed to 0 0 0 F100 t1.2
1/104 depth 1: feed arc to 25 0 -25 center 0 0 -25 normal 0 1 0 sweep 90 F100 t23.5619
1/105 depth 1: feed arc to 50 0 -50 center 50 0 -25 normal 0 1 0 sweep -90 F100 t23.5619
1/106 depth 1: rapid to 53 0 -50 t0.012
1/107 depth 1: rapid to 53 0 2 t0.208
5: rapid to 100 0 100 t0.392
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 108 motions, 0 errors, 0 warnings
