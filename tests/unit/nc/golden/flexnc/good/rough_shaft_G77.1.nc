=== about
Roughing of a shaft: G77.1X120Y30Z12G37P1.3C2B2V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.2-G77.1 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G77.1X120Y30Z12G37P1.3C2B2V0
G81X200Z100
M02
=== truth
62 0 2
58.7 0 2
58.7 0 -40.274842
59.1 0 -40.274842
59.1 0 2
57.4 0 2
57.4 0 -38.549683
57.8 0 -38.549683
57.8 0 2
56.1 0 2
56.1 0 -36.824525
56.5 0 -36.824525
56.5 0 2
54.8 0 2
54.8 0 -35.099367
55.2 0 -35.099367
55.2 0 2
53.5 0 2
53.5 0 -33.374209
53.9 0 -33.374209
53.9 0 2
52.2 0 2
52.2 0 -31.64905
52.6 0 -31.64905
52.6 0 2
50.9 0 2
50.9 0 -29.923892
51.3 0 -29.923892
51.3 0 2
49.6 0 2
49.6 0 -28.198734
50 0 -28.198734
50 0 2
48.3 0 2
48.3 0 -26.473576
48.7 0 -26.473576
48.7 0 2
47 0 2
47 0 -24.748417
47.4 0 -24.748417
47.4 0 2
45.7 0 2
45.7 0 -23.023259
46.1 0 -23.023259
46.1 0 2
44.4 0 2
44.4 0 -21.298101
44.8 0 -21.298101
44.8 0 2
43.1 0 2
43.1 0 -19.572943
43.5 0 -19.572943
43.5 0 2
41.8 0 2
41.8 0 -17.847784
42.2 0 -17.847784
42.2 0 2
40.5 0 2
40.5 0 -16.122626
40.9 0 -16.122626
40.9 0 2
39.2 0 2
39.2 0 -14.397468
39.6 0 -14.397468
39.6 0 2
37.9 0 2
37.9 0 -12.672309
38.3 0 -12.672309
38.3 0 2
37.393378 0 2
37.393378 0 -12
60 0 -42
62 0 -42
62 0 2
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G77.1 of line 4
1/1 depth 1: rapid from 100 0 50 to 62 0 2 t0.192
1/2 depth 1: feed to 58.7 0 2 F100 t1.98
1/3 depth 1: feed to 58.7 0 -40.2748 F100 t25.3649
1/4 depth 1: feed to 59.1 0 -40.2748 F100 t0.24
1/5 depth 1: rapid to 59.1 0 2 t0.1691
1/6 depth 1: feed to 57.4 0 2 F100 t1.02
1/7 depth 1: feed to 57.4 0 -38.5497 F100 t24.3298
1/8 depth 1: feed to 57.8 0 -38.5497 F100 t0.24
1/9 depth 1: rapid to 57.8 0 2 t0.1622
1/10 depth 1: feed to 56.1 0 2 F100 t1.02
1/11 depth 1: feed to 56.1 0 -36.8245 F100 t23.2947
1/12 depth 1: feed to 56.5 0 -36.8245 F100 t0.24
1/13 depth 1: rapid to 56.5 0 2 t0.1553
1/14 depth 1: feed to 54.8 0 2 F100 t1.02
1/15 depth 1: feed to 54.8 0 -35.0994 F100 t22.2596
1/16 depth 1: feed to 55.2 0 -35.0994 F100 t0.24
1/17 depth 1: rapid to 55.2 0 2 t0.1484
1/18 depth 1: feed to 53.5 0 2 F100 t1.02
1/19 depth 1: feed to 53.5 0 -33.3742 F100 t21.2245
1/20 depth 1: feed to 53.9 0 -33.3742 F100 t0.24
1/21 depth 1: rapid to 53.9 0 2 t0.1415
1/22 depth 1: feed to 52.2 0 2 F100 t1.02
1/23 depth 1: feed to 52.2 0 -31.6491 F100 t20.1894
1/24 depth 1: feed to 52.6 0 -31.6491 F100 t0.24
1/25 depth 1: rapid to 52.6 0 2 t0.1346
1/26 depth 1: feed to 50.9 0 2 F100 t1.02
1/27 depth 1: feed to 50.9 0 -29.9239 F100 t19.1543
1/28 depth 1: feed to 51.3 0 -29.9239 F100 t0.24
1/29 depth 1: rapid to 51.3 0 2 t0.1277
1/30 depth 1: feed to 49.6 0 2 F100 t1.02
1/31 depth 1: feed to 49.6 0 -28.1987 F100 t18.1192
1/32 depth 1: feed to 50 0 -28.1987 F100 t0.24
1/33 depth 1: rapid to 50 0 2 t0.1208
1/34 depth 1: feed to 48.3 0 2 F100 t1.02
1/35 depth 1: feed to 48.3 0 -26.4736 F100 t17.0841
1/36 depth 1: feed to 48.7 0 -26.4736 F100 t0.24
1/37 depth 1: rapid to 48.7 0 2 t0.1139
1/38 depth 1: feed to 47 0 2 F100 t1.02
1/39 depth 1: feed to 47 0 -24.7484 F100 t16.0491
1/40 depth 1: feed to 47.4 0 -24.7484 F100 t0.24
1/41 depth 1: rapid to 47.4 0 2 t0.107
1/42 depth 1: feed to 45.7 0 2 F100 t1.02
1/43 depth 1: feed to 45.7 0 -23.0233 F100 t15.014
1/44 depth 1: feed to 46.1 0 -23.0233 F100 t0.24
1/45 depth 1: rapid to 46.1 0 2 t0.1001
1/46 depth 1: feed to 44.4 0 2 F100 t1.02
1/47 depth 1: feed to 44.4 0 -21.2981 F100 t13.9789
1/48 depth 1: feed to 44.8 0 -21.2981 F100 t0.24
1/49 depth 1: rapid to 44.8 0 2 t0.0932
1/50 depth 1: feed to 43.1 0 2 F100 t1.02
1/51 depth 1: feed to 43.1 0 -19.5729 F100 t12.9438
1/52 depth 1: feed to 43.5 0 -19.5729 F100 t0.24
1/53 depth 1: rapid to 43.5 0 2 t0.0863
1/54 depth 1: feed to 41.8 0 2 F100 t1.02
1/55 depth 1: feed to 41.8 0 -17.8478 F100 t11.9087
1/56 depth 1: feed to 42.2 0 -17.8478 F100 t0.24
1/57 depth 1: rapid to 42.2 0 2 t0.0794
1/58 depth 1: feed to 40.5 0 2 F100 t1.02
1/59 depth 1: feed to 40.5 0 -16.1226 F100 t10.8736
1/60 depth 1: feed to 40.9 0 -16.1226 F100 t0.24
1/61 depth 1: rapid to 40.9 0 2 t0.0725
1/62 depth 1: feed to 39.2 0 2 F100 t1.02
1/63 depth 1: feed to 39.2 0 -14.3975 F100 t9.8385
1/64 depth 1: feed to 39.6 0 -14.3975 F100 t0.24
1/65 depth 1: rapid to 39.6 0 2 t0.0656
1/66 depth 1: feed to 37.9 0 2 F100 t1.02
1/67 depth 1: feed to 37.9 0 -12.6723 F100 t8.8034
1/68 depth 1: feed to 38.3 0 -12.6723 F100 t0.24
1/69 depth 1: rapid to 38.3 0 2 t0.0587
1/70 depth 1: feed to 37.3934 0 2 F100 t0.544
1/71 depth 1: feed to 37.3934 0 -12 F100 t8.4
1/72 depth 1: feed to 60 0 -42 F100 t22.5384
1/73 depth 1: rapid to 62 0 -42 t0.008
1/74 depth 1: rapid to 62 0 2 t0.176
5: rapid to 100 0 100 t0.392
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 75 motions, 0 errors, 0 warnings
