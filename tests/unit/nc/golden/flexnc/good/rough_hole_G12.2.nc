=== about
Roughing of a hole: G12.2A120Y25Z0R12G45P2C-3B3V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.3-G12.2 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G12.2A120Y25Z0R12G45P2C-3B3V0
G81X200Z100
M02
=== truth
27.029437 0 3
32.029437 0 3
32.029437 0 -23
31.429437 0 -23
31.429437 0 3
34.029437 0 3
34.029437 0 -21
33.429437 0 -21
33.429437 0 3
36.029437 0 3
36.029437 0 -19
35.429437 0 -19
35.429437 0 3
38.029437 0 3
38.029437 0 -17
37.429437 0 -17
37.429437 0 3
40.029437 0 3
40.029437 0 -15
39.429437 0 -15
39.429437 0 3
42.029437 0 3
42.029437 0 -13
41.429437 0 -13
41.429437 0 3
44.029437 0 3
44.029437 0 -11
43.429437 0 -11
43.429437 0 3
46.029437 0 3
46.029437 0 -9
45.429437 0 -9
45.429437 0 3
48.029437 0 3
48.029437 0 -7
47.429437 0 -7
47.429437 0 3
50.029437 0 3
50.029437 0 -5
49.429437 0 -5
49.429437 0 3
51.514719 0 3
51.514719 0 -3.514719
50.914719 0 -3.514719
50.914719 0 3
53.514719 0 3
53.514719 0 -1.90341
52.914719 0 -1.90341
52.914719 0 3
55.514719 0 3
55.514719 0 -0.86976
54.914719 0 -0.86976
54.914719 0 3
57.514719 0 3
57.514719 0 -0.26018
56.914719 0 -0.26018
56.914719 0 3
59.514719 0 3
59.514719 0 -0.009816
58.914719 0 -0.009816
58.914719 0 3
60 0 3
60 0 0
51.514719 0 -3.514719 center 60 0 -12 sweep -45
30.029437 0 -25
30.029437 0 3
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G12.2 of line 4
1/1 depth 1: rapid from 100 0 50 to 27.0294 0 3 t0.2919
1/2 depth 1: feed to 32.0294 0 3 F100 t3
1/3 depth 1: feed to 32.0294 0 -23 F100 t15.6
1/4 depth 1: feed to 31.4294 0 -23 F100 t0.36
1/5 depth 1: rapid to 31.4294 0 3 t0.104
1/6 depth 1: feed to 34.0294 0 3 F100 t1.56
1/7 depth 1: feed to 34.0294 0 -21 F100 t14.4
1/8 depth 1: feed to 33.4294 0 -21 F100 t0.36
1/9 depth 1: rapid to 33.4294 0 3 t0.096
1/10 depth 1: feed to 36.0294 0 3 F100 t1.56
1/11 depth 1: feed to 36.0294 0 -19 F100 t13.2
1/12 depth 1: feed to 35.4294 0 -19 F100 t0.36
1/13 depth 1: rapid to 35.4294 0 3 t0.088
1/14 depth 1: feed to 38.0294 0 3 F100 t1.56
1/15 depth 1: feed to 38.0294 0 -17 F100 t12
1/16 depth 1: feed to 37.4294 0 -17 F100 t0.36
1/17 depth 1: rapid to 37.4294 0 3 t0.08
1/18 depth 1: feed to 40.0294 0 3 F100 t1.56
1/19 depth 1: feed to 40.0294 0 -15 F100 t10.8
1/20 depth 1: feed to 39.4294 0 -15 F100 t0.36
1/21 depth 1: rapid to 39.4294 0 3 t0.072
1/22 depth 1: feed to 42.0294 0 3 F100 t1.56
1/23 depth 1: feed to 42.0294 0 -13 F100 t9.6
1/24 depth 1: feed to 41.4294 0 -13 F100 t0.36
1/25 depth 1: rapid to 41.4294 0 3 t0.064
1/26 depth 1: feed to 44.0294 0 3 F100 t1.56
1/27 depth 1: feed to 44.0294 0 -11 F100 t8.4
1/28 depth 1: feed to 43.4294 0 -11 F100 t0.36
1/29 depth 1: rapid to 43.4294 0 3 t0.056
1/30 depth 1: feed to 46.0294 0 3 F100 t1.56
1/31 depth 1: feed to 46.0294 0 -9 F100 t7.2
1/32 depth 1: feed to 45.4294 0 -9 F100 t0.36
1/33 depth 1: rapid to 45.4294 0 3 t0.048
1/34 depth 1: feed to 48.0294 0 3 F100 t1.56
1/35 depth 1: feed to 48.0294 0 -7 F100 t6
1/36 depth 1: feed to 47.4294 0 -7 F100 t0.36
1/37 depth 1: rapid to 47.4294 0 3 t0.04
1/38 depth 1: feed to 50.0294 0 3 F100 t1.56
1/39 depth 1: feed to 50.0294 0 -5 F100 t4.8
1/40 depth 1: feed to 49.4294 0 -5 F100 t0.36
1/41 depth 1: rapid to 49.4294 0 3 t0.032
1/42 depth 1: feed to 51.5147 0 3 F100 t1.2512
1/43 depth 1: feed to 51.5147 0 -3.5147 F100 t3.9088
1/44 depth 1: feed to 50.9147 0 -3.5147 F100 t0.36
1/45 depth 1: rapid to 50.9147 0 3 t0.0261
1/46 depth 1: feed to 53.5147 0 3 F100 t1.56
1/47 depth 1: feed to 53.5147 0 -1.9034 F100 t2.942
1/48 depth 1: feed to 52.9147 0 -1.9034 F100 t0.36
1/49 depth 1: rapid to 52.9147 0 3 t0.0196
1/50 depth 1: feed to 55.5147 0 3 F100 t1.56
1/51 depth 1: feed to 55.5147 0 -0.8698 F100 t2.3219
1/52 depth 1: feed to 54.9147 0 -0.8698 F100 t0.36
1/53 depth 1: rapid to 54.9147 0 3 t0.0155
1/54 depth 1: feed to 57.5147 0 3 F100 t1.56
1/55 depth 1: feed to 57.5147 0 -0.2602 F100 t1.9561
1/56 depth 1: feed to 56.9147 0 -0.2602 F100 t0.36
1/57 depth 1: rapid to 56.9147 0 3 t0.013
1/58 depth 1: feed to 59.5147 0 3 F100 t1.56
1/59 depth 1: feed to 59.5147 0 -0.0098 F100 t1.8059
1/60 depth 1: feed to 58.9147 0 -0.0098 F100 t0.36
1/61 depth 1: rapid to 58.9147 0 3 t0.012
1/62 depth 1: feed to 60 0 3 F100 t0.6512
1/63 depth 1: feed to 60 0 0 F100 t1.8
1/64 depth 1: feed arc to 51.5147 0 -3.5147 center 60 0 -12 normal 0 1 0 sweep -45 F100 t5.6549
1/65 depth 1: feed to 30.0294 0 -25 F100 t18.2309
1/66 depth 1: rapid to 30.0294 0 3 t0.112
5: rapid to 100 0 100 t0.388
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 67 motions, 0 errors, 0 warnings
