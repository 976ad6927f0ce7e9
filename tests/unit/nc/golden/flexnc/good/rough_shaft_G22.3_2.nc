=== about
Roughing of a shaft: G22.3A60Y40Z5G30R0U8P2B2C2V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.2-G22.3 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G22.3A60Y40Z5G30R0U8P2B2C2V0
G81X200Z100
M02
=== truth
53.856406 0 2
50.78461 0 2
50.78461 0 -41
51.18461 0 -41
51.18461 0 2
48.78461 0 2
48.78461 0 -37.535898
49.18461 0 -37.535898
49.18461 0 2
46.78461 0 2
46.78461 0 -34.071797
47.18461 0 -34.071797
47.18461 0 2
44.78461 0 2
44.78461 0 -30.607695
45.18461 0 -30.607695
45.18461 0 2
42.78461 0 2
42.78461 0 -27.143594
43.18461 0 -27.143594
43.18461 0 2
40.78461 0 2
40.78461 0 -23.679492
41.18461 0 -23.679492
41.18461 0 2
38.78461 0 2
38.78461 0 -20.21539
39.18461 0 -20.21539
39.18461 0 2
36.78461 0 2
36.78461 0 -16.751289
37.18461 0 -16.751289
37.18461 0 2
34.78461 0 2
34.78461 0 -13.287187
35.18461 0 -13.287187
35.18461 0 2
32.78461 0 2
32.78461 0 -9.823085
33.18461 0 -9.823085
33.18461 0 2
30.78461 0 2
30.78461 0 -6.358984
31.18461 0 -6.358984
31.18461 0 2
30 0 2
30 0 -5
50.78461 0 -41
51.856406 0 -45 center 43.856406 0 -45 sweep 30
53.856406 0 -45
53.856406 0 2
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G22.3 of line 4
1/1 depth 1: rapid from 100 0 50 to 53.8564 0 2 t0.192
1/2 depth 1: feed to 50.7846 0 2 F100 t1.8431
1/3 depth 1: feed to 50.7846 0 -41 F100 t25.8
1/4 depth 1: feed to 51.1846 0 -41 F100 t0.24
1/5 depth 1: rapid to 51.1846 0 2 t0.172
1/6 depth 1: feed to 48.7846 0 2 F100 t1.44
1/7 depth 1: feed to 48.7846 0 -37.5359 F100 t23.7215
1/8 depth 1: feed to 49.1846 0 -37.5359 F100 t0.24
1/9 depth 1: rapid to 49.1846 0 2 t0.1581
1/10 depth 1: feed to 46.7846 0 2 F100 t1.44
1/11 depth 1: feed to 46.7846 0 -34.0718 F100 t21.6431
1/12 depth 1: feed to 47.1846 0 -34.0718 F100 t0.24
1/13 depth 1: rapid to 47.1846 0 2 t0.1443
1/14 depth 1: feed to 44.7846 0 2 F100 t1.44
1/15 depth 1: feed to 44.7846 0 -30.6077 F100 t19.5646
1/16 depth 1: feed to 45.1846 0 -30.6077 F100 t0.24
1/17 depth 1: rapid to 45.1846 0 2 t0.1304
1/18 depth 1: feed to 42.7846 0 2 F100 t1.44
1/19 depth 1: feed to 42.7846 0 -27.1436 F100 t17.4862
1/20 depth 1: feed to 43.1846 0 -27.1436 F100 t0.24
1/21 depth 1: rapid to 43.1846 0 2 t0.1166
1/22 depth 1: feed to 40.7846 0 2 F100 t1.44
1/23 depth 1: feed to 40.7846 0 -23.6795 F100 t15.4077
1/24 depth 1: feed to 41.1846 0 -23.6795 F100 t0.24
1/25 depth 1: rapid to 41.1846 0 2 t0.1027
1/26 depth 1: feed to 38.7846 0 2 F100 t1.44
1/27 depth 1: feed to 38.7846 0 -20.2154 F100 t13.3292
1/28 depth 1: feed to 39.1846 0 -20.2154 F100 t0.24
1/29 depth 1: rapid to 39.1846 0 2 t0.0889
1/30 depth 1: feed to 36.7846 0 2 F100 t1.44
1/31 depth 1: feed to 36.7846 0 -16.7513 F100 t11.2508
1/32 depth 1: feed to 37.1846 0 -16.7513 F100 t0.24
1/33 depth 1: rapid to 37.1846 0 2 t0.075
1/34 depth 1: feed to 34.7846 0 2 F100 t1.44
1/35 depth 1: feed to 34.7846 0 -13.2872 F100 t9.1723
1/36 depth 1: feed to 35.1846 0 -13.2872 F100 t0.24
1/37 depth 1: rapid to 35.1846 0 2 t0.0611
1/38 depth 1: feed to 32.7846 0 2 F100 t1.44
1/39 depth 1: feed to 32.7846 0 -9.8231 F100 t7.0939
1/40 depth 1: feed to 33.1846 0 -9.8231 F100 t0.24
1/41 depth 1: rapid to 33.1846 0 2 t0.0473
1/42 depth 1: feed to 30.7846 0 2 F100 t1.44
1/43 depth 1: feed to 30.7846 0 -6.359 F100 t5.0154
1/44 depth 1: feed to 31.1846 0 -6.359 F100 t0.24
1/45 depth 1: rapid to 31.1846 0 2 t0.0334
1/46 depth 1: feed to 30 0 2 F100 t0.7108
1/47 depth 1: feed to 30 0 -5 F100 t4.2
1/48 depth 1: feed to 50.7846 0 -41 F100 t24.9415
1/49 depth 1: feed arc to 51.8564 0 -45 center 43.8564 0 -45 normal 0 1 0 sweep 30 F100 t2.5133
1/50 depth 1: rapid to 53.8564 0 -45 t0.008
1/51 depth 1: rapid to 53.8564 0 2 t0.188
5: rapid to 100 0 100 t0.392
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 52 motions, 0 errors, 0 warnings
