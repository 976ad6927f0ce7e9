=== about
Roughing of a hole: G12.5X10A70Z0G45R15P2C-3B2V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.3-G12.5 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G12.5X10A70Z0G45R15P2C-3B2V0
G81X200Z100
M02
=== truth
2 0 2
7 0 2
7 0 -21.786797
6.4 0 -21.786797
6.4 0 2
9 0 2
9 0 -19.786797
8.4 0 -19.786797
8.4 0 2
11 0 2
11 0 -17.786797
10.4 0 -17.786797
10.4 0 2
13 0 2
13 0 -15.786797
12.4 0 -15.786797
12.4 0 2
15 0 2
15 0 -13.786797
14.4 0 -13.786797
14.4 0 2
17 0 2
17 0 -11.786797
16.4 0 -11.786797
16.4 0 2
19 0 2
19 0 -9.786797
18.4 0 -9.786797
18.4 0 2
21 0 2
21 0 -7.786797
20.4 0 -7.786797
20.4 0 2
23 0 2
23 0 -5.786797
22.4 0 -5.786797
22.4 0 2
24.393398 0 2
24.393398 0 -4.393398
23.793398 0 -4.393398
23.793398 0 2
26.393398 0 2
26.393398 0 -2.714789
25.793398 0 -2.714789
25.793398 0 2
28.393398 0 2
28.393398 0 -1.53327
27.793398 0 -1.53327
27.793398 0 2
30.393398 0 2
30.393398 0 -0.724874
29.793398 0 -0.724874
29.793398 0 2
32.393398 0 2
32.393398 0 -0.228215
31.793398 0 -0.228215
31.793398 0 2
34.393398 0 2
34.393398 0 -0.012271
33.793398 0 -0.012271
33.793398 0 2
35 0 2
35 0 0
24.393398 0 -4.393398 center 35 0 -15 sweep -45
5 0 -23.786797
5 0 2
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G12.5 of line 4
1/1 depth 1: rapid from 100 0 50 to 2 0 2 t0.392
1/2 depth 1: feed to 7 0 2 F100 t3
1/3 depth 1: feed to 7 0 -21.7868 F100 t14.2721
1/4 depth 1: feed to 6.4 0 -21.7868 F100 t0.36
1/5 depth 1: rapid to 6.4 0 2 t0.0951
1/6 depth 1: feed to 9 0 2 F100 t1.56
1/7 depth 1: feed to 9 0 -19.7868 F100 t13.0721
1/8 depth 1: feed to 8.4 0 -19.7868 F100 t0.36
1/9 depth 1: rapid to 8.4 0 2 t0.0871
1/10 depth 1: feed to 11 0 2 F100 t1.56
1/11 depth 1: feed to 11 0 -17.7868 F100 t11.8721
1/12 depth 1: feed to 10.4 0 -17.7868 F100 t0.36
1/13 depth 1: rapid to 10.4 0 2 t0.0791
1/14 depth 1: feed to 13 0 2 F100 t1.56
1/15 depth 1: feed to 13 0 -15.7868 F100 t10.6721
1/16 depth 1: feed to 12.4 0 -15.7868 F100 t0.36
1/17 depth 1: rapid to 12.4 0 2 t0.0711
1/18 depth 1: feed to 15 0 2 F100 t1.56
1/19 depth 1: feed to 15 0 -13.7868 F100 t9.4721
1/20 depth 1: feed to 14.4 0 -13.7868 F100 t0.36
1/21 depth 1: rapid to 14.4 0 2 t0.0631
1/22 depth 1: feed to 17 0 2 F100 t1.56
1/23 depth 1: feed to 17 0 -11.7868 F100 t8.2721
1/24 depth 1: feed to 16.4 0 -11.7868 F100 t0.36
1/25 depth 1: rapid to 16.4 0 2 t0.0551
1/26 depth 1: feed to 19 0 2 F100 t1.56
1/27 depth 1: feed to 19 0 -9.7868 F100 t7.0721
1/28 depth 1: feed to 18.4 0 -9.7868 F100 t0.36
1/29 depth 1: rapid to 18.4 0 2 t0.0471
1/30 depth 1: feed to 21 0 2 F100 t1.56
1/31 depth 1: feed to 21 0 -7.7868 F100 t5.8721
1/32 depth 1: feed to 20.4 0 -7.7868 F100 t0.36
1/33 depth 1: rapid to 20.4 0 2 t0.0391
1/34 depth 1: feed to 23 0 2 F100 t1.56
1/35 depth 1: feed to 23 0 -5.7868 F100 t4.6721
1/36 depth 1: feed to 22.4 0 -5.7868 F100 t0.36
1/37 depth 1: rapid to 22.4 0 2 t0.0311
1/38 depth 1: feed to 24.3934 0 2 F100 t1.196
1/39 depth 1: feed to 24.3934 0 -4.3934 F100 t3.836
1/40 depth 1: feed to 23.7934 0 -4.3934 F100 t0.36
1/41 depth 1: rapid to 23.7934 0 2 t0.0256
1/42 depth 1: feed to 26.3934 0 2 F100 t1.56
1/43 depth 1: feed to 26.3934 0 -2.7148 F100 t2.8289
1/44 depth 1: feed to 25.7934 0 -2.7148 F100 t0.36
1/45 depth 1: rapid to 25.7934 0 2 t0.0189
1/46 depth 1: feed to 28.3934 0 2 F100 t1.56
1/47 depth 1: feed to 28.3934 0 -1.5333 F100 t2.12
1/48 depth 1: feed to 27.7934 0 -1.5333 F100 t0.36
1/49 depth 1: rapid to 27.7934 0 2 t0.0141
1/50 depth 1: feed to 30.3934 0 2 F100 t1.56
1/51 depth 1: feed to 30.3934 0 -0.7249 F100 t1.6349
1/52 depth 1: feed to 29.7934 0 -0.7249 F100 t0.36
1/53 depth 1: rapid to 29.7934 0 2 t0.0109
1/54 depth 1: feed to 32.3934 0 2 F100 t1.56
1/55 depth 1: feed to 32.3934 0 -0.2282 F100 t1.3369
1/56 depth 1: feed to 31.7934 0 -0.2282 F100 t0.36
1/57 depth 1: rapid to 31.7934 0 2 t0.0089
1/58 depth 1: feed to 34.3934 0 2 F100 t1.56
1/59 depth 1: feed to 34.3934 0 -0.0123 F100 t1.2074
1/60 depth 1: feed to 33.7934 0 -0.0123 F100 t0.36
1/61 depth 1: rapid to 33.7934 0 2 t0.008
1/62 depth 1: feed to 35 0 2 F100 t0.724
1/63 depth 1: feed to 35 0 0 F100 t1.2
1/64 depth 1: feed arc to 24.3934 0 -4.3934 center 35 0 -15 normal 0 1 0 sweep -45 F100 t7.0686
1/65 depth 1: feed to 5 0 -23.7868 F100 t16.4558
1/66 depth 1: rapid to 5 0 2 t0.1031
5: rapid to 100 0 100 t0.392
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 67 motions, 0 errors, 0 warnings
