=== about
Roughing of a shaft: G13X70R18Z0P1.5C2B2V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.2-G13 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G13X70R18Z0P1.5C2B2V0
G81X200Z100
M02
=== truth
37 0 2
33.5 0 2
33.5 0 -17.937391
33.9 0 -17.937391
33.9 0 2
32 0 2
32 0 -17.748239
32.4 0 -17.748239
32.4 0 2
30.5 0 2
30.5 0 -17.428425
30.9 0 -17.428425
30.9 0 2
29 0 2
29 0 -16.970563
29.4 0 -16.970563
29.4 0 2
27.5 0 2
27.5 0 -16.363068
27.9 0 -16.363068
27.9 0 2
26 0 2
26 0 -15.588457
26.4 0 -15.588457
26.4 0 2
24.5 0 2
24.5 0 -14.620192
24.9 0 -14.620192
24.9 0 2
23 0 2
23 0 -13.416408
23.4 0 -13.416408
23.4 0 2
21.5 0 2
21.5 0 -11.905881
21.9 0 -11.905881
21.9 0 2
20 0 2
20 0 -9.949874
20.4 0 -9.949874
20.4 0 2
18.5 0 2
18.5 0 -7.193747
18.9 0 -7.193747
18.9 0 2
17 0 2
17 0 0
35 0 -18 center 35 0 0 sweep -90
37 0 -18
37 0 2
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G13 of line 4
1/1 depth 1: rapid from 100 0 50 to 37 0 2 t0.252
1/2 depth 1: feed to 33.5 0 2 F100 t2.1
1/3 depth 1: feed to 33.5 0 -17.9374 F100 t11.9624
1/4 depth 1: feed to 33.9 0 -17.9374 F100 t0.24
1/5 depth 1: rapid to 33.9 0 2 t0.0797
1/6 depth 1: feed to 32 0 2 F100 t1.14
1/7 depth 1: feed to 32 0 -17.7482 F100 t11.8489
1/8 depth 1: feed to 32.4 0 -17.7482 F100 t0.24
1/9 depth 1: rapid to 32.4 0 2 t0.079
1/10 depth 1: feed to 30.5 0 2 F100 t1.14
1/11 depth 1: feed to 30.5 0 -17.4284 F100 t11.6571
1/12 depth 1: feed to 30.9 0 -17.4284 F100 t0.24
1/13 depth 1: rapid to 30.9 0 2 t0.0777
1/14 depth 1: feed to 29 0 2 F100 t1.14
1/15 depth 1: feed to 29 0 -16.9706 F100 t11.3823
1/16 depth 1: feed to 29.4 0 -16.9706 F100 t0.24
1/17 depth 1: rapid to 29.4 0 2 t0.0759
1/18 depth 1: feed to 27.5 0 2 F100 t1.14
1/19 depth 1: feed to 27.5 0 -16.3631 F100 t11.0178
1/20 depth 1: feed to 27.9 0 -16.3631 F100 t0.24
1/21 depth 1: rapid to 27.9 0 2 t0.0735
1/22 depth 1: feed to 26 0 2 F100 t1.14
1/23 depth 1: feed to 26 0 -15.5885 F100 t10.5531
1/24 depth 1: feed to 26.4 0 -15.5885 F100 t0.24
1/25 depth 1: rapid to 26.4 0 2 t0.0704
1/26 depth 1: feed to 24.5 0 2 F100 t1.14
1/27 depth 1: feed to 24.5 0 -14.6202 F100 t9.9721
1/28 depth 1: feed to 24.9 0 -14.6202 F100 t0.24
1/29 depth 1: rapid to 24.9 0 2 t0.0665
1/30 depth 1: feed to 23 0 2 F100 t1.14
1/31 depth 1: feed to 23 0 -13.4164 F100 t9.2498
1/32 depth 1: feed to 23.4 0 -13.4164 F100 t0.24
1/33 depth 1: rapid to 23.4 0 2 t0.0617
1/34 depth 1: feed to 21.5 0 2 F100 t1.14
1/35 depth 1: feed to 21.5 0 -11.9059 F100 t8.3435
1/36 depth 1: feed to 21.9 0 -11.9059 F100 t0.24
1/37 depth 1: rapid to 21.9 0 2 t0.0556
1/38 depth 1: feed to 20 0 2 F100 t1.14
1/39 depth 1: feed to 20 0 -9.9499 F100 t7.1699
1/40 depth 1: feed to 20.4 0 -9.9499 F100 t0.24
1/41 depth 1: rapid to 20.4 0 2 t0.0478
1/42 depth 1: feed to 18.5 0 2 F100 t1.14
1/43 depth 1: feed to 18.5 0 -7.1937 F100 t5.5162
1/44 depth 1: feed to 18.9 0 -7.1937 F100 t0.24
1/45 depth 1: rapid to 18.9 0 2 t0.0368
1/46 depth 1: feed to 17 0 2 F100 t1.14
1/47 depth 1: feed to 17 0 0 F100 t1.2
1/48 depth 1: feed arc to 35 0 -18 center 35 0 0 normal 0 1 0 sweep -90 F100 t16.9646
1/49 depth 1: rapid to 37 0 -18 t0.008
1/50 depth 1: rapid to 37 0 2 t0.08
5: rapid to 100 0 100 t0.392
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 51 motions, 0 errors, 0 warnings
