=== about
Roughing of a shaft: G12.5A0X90Z35R10G55P1C2B3V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.2-G12.5 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G12.5A0X90Z35R10G55P1C2B3V0
G81X200Z100
M02
=== truth
47 0 3
44 0 3
44 0 -34.299792
44.4 0 -34.299792
44.4 0 3
43 0 3
43 0 -33.599585
43.4 0 -33.599585
43.4 0 3
42 0 3
42 0 -32.899377
42.4 0 -32.899377
42.4 0 3
41 0 3
41 0 -32.19917
41.4 0 -32.19917
41.4 0 3
40 0 3
40 0 -31.498962
40.4 0 -31.498962
40.4 0 3
39 0 3
39 0 -30.798755
39.4 0 -30.798755
39.4 0 3
38 0 3
38 0 -30.098547
38.4 0 -30.098547
38.4 0 3
37 0 3
37 0 -29.39834
37.4 0 -29.39834
37.4 0 3
36 0 3
36 0 -28.698132
36.4 0 -28.698132
36.4 0 3
35 0 3
35 0 -27.997925
35.4 0 -27.997925
35.4 0 3
34 0 3
34 0 -27.297717
34.4 0 -27.297717
34.4 0 3
33 0 3
33 0 -26.59751
33.4 0 -26.59751
33.4 0 3
32 0 3
32 0 -25.897302
32.4 0 -25.897302
32.4 0 3
31 0 3
31 0 -25.197094
31.4 0 -25.197094
31.4 0 3
30 0 3
30 0 -24.496887
30.4 0 -24.496887
30.4 0 3
29 0 3
29 0 -23.796679
29.4 0 -23.796679
29.4 0 3
28 0 3
28 0 -23.096472
28.4 0 -23.096472
28.4 0 3
27 0 3
27 0 -22.396264
27.4 0 -22.396264
27.4 0 3
26 0 3
26 0 -21.696057
26.4 0 -21.696057
26.4 0 3
25 0 3
25 0 -20.995849
25.4 0 -20.995849
25.4 0 3
24 0 3
24 0 -20.295642
24.4 0 -20.295642
24.4 0 3
23 0 3
23 0 -19.595434
23.4 0 -19.595434
23.4 0 3
22 0 3
22 0 -18.895227
22.4 0 -18.895227
22.4 0 3
21 0 3
21 0 -18.195019
21.4 0 -18.195019
21.4 0 3
20 0 3
20 0 -17.494812
20.4 0 -17.494812
20.4 0 3
19 0 3
19 0 -16.794604
19.4 0 -16.794604
19.4 0 3
18 0 3
18 0 -16.094396
18.4 0 -16.094396
18.4 0 3
17 0 3
17 0 -15.394189
17.4 0 -15.394189
17.4 0 3
16 0 3
16 0 -14.693981
16.4 0 -14.693981
16.4 0 3
15 0 3
15 0 -13.993774
15.4 0 -13.993774
15.4 0 3
14 0 3
14 0 -13.293566
14.4 0 -13.293566
14.4 0 3
13 0 3
13 0 -12.593359
13.4 0 -12.593359
13.4 0 3
12 0 3
12 0 -11.893151
12.4 0 -11.893151
12.4 0 3
11 0 3
11 0 -11.192944
11.4 0 -11.192944
11.4 0 3
10 0 3
10 0 -10.492736
10.4 0 -10.492736
10.4 0 3
9 0 3
9 0 -9.792529
9.4 0 -9.792529
9.4 0 3
8 0 3
8 0 -9.092321
8.4 0 -9.092321
8.4 0 3
7 0 3
7 0 -8.392114
7.4 0 -8.392114
7.4 0 3
6 0 3
6 0 -7.691906
6.4 0 -7.691906
6.4 0 3
5.735764 0 3
5.735764 0 -7.506886
6.135764 0 -7.506886
6.135764 0 3
4.735764 0 3
4.735764 0 -6.890879
5.135764 0 -6.890879
5.135764 0 3
3.735764 0 3
3.735764 0 -6.422413
4.135764 0 -6.422413
4.135764 0 3
2.735764 0 3
2.735764 0 -6.079904
3.135764 0 -6.079904
3.135764 0 3
1.735764 0 3
1.735764 0 -5.850203
2.135764 0 -5.850203
2.135764 0 3
0.735764 0 3
0.735764 0 -5.725511
1.135764 0 -5.725511
1.135764 0 3
0 0 3
0 0 -5.698407
5.735764 0 -7.506886 center 0 0 -15.698407 sweep 35
45 0 -35
47 0 -35
47 0 3
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G12.5 of line 4
1/1 depth 1: rapid from 100 0 50 to 47 0 3 t0.212
1/2 depth 1: feed to 44 0 3 F100 t1.8
1/3 depth 1: feed to 44 0 -34.2998 F100 t22.3799
1/4 depth 1: feed to 44.4 0 -34.2998 F100 t0.24
1/5 depth 1: rapid to 44.4 0 3 t0.1492
1/6 depth 1: feed to 43 0 3 F100 t0.84
1/7 depth 1: feed to 43 0 -33.5996 F100 t21.9598
1/8 depth 1: feed to 43.4 0 -33.5996 F100 t0.24
1/9 depth 1: rapid to 43.4 0 3 t0.1464
1/10 depth 1: feed to 42 0 3 F100 t0.84
1/11 depth 1: feed to 42 0 -32.8994 F100 t21.5396
1/12 depth 1: feed to 42.4 0 -32.8994 F100 t0.24
1/13 depth 1: rapid to 42.4 0 3 t0.1436
1/14 depth 1: feed to 41 0 3 F100 t0.84
1/15 depth 1: feed to 41 0 -32.1992 F100 t21.1195
1/16 depth 1: feed to 41.4 0 -32.1992 F100 t0.24
1/17 depth 1: rapid to 41.4 0 3 t0.1408
1/18 depth 1: feed to 40 0 3 F100 t0.84
1/19 depth 1: feed to 40 0 -31.499 F100 t20.6994
1/20 depth 1: feed to 40.4 0 -31.499 F100 t0.24
1/21 depth 1: rapid to 40.4 0 3 t0.138
1/22 depth 1: feed to 39 0 3 F100 t0.84
1/23 depth 1: feed to 39 0 -30.7988 F100 t20.2793
1/24 depth 1: feed to 39.4 0 -30.7988 F100 t0.24
1/25 depth 1: rapid to 39.4 0 3 t0.1352
1/26 depth 1: feed to 38 0 3 F100 t0.84
1/27 depth 1: feed to 38 0 -30.0985 F100 t19.8591
1/28 depth 1: feed to 38.4 0 -30.0985 F100 t0.24
1/29 depth 1: rapid to 38.4 0 3 t0.1324
1/30 depth 1: feed to 37 0 3 F100 t0.84
1/31 depth 1: feed to 37 0 -29.3983 F100 t19.439
1/32 depth 1: feed to 37.4 0 -29.3983 F100 t0.24
1/33 depth 1: rapid to 37.4 0 3 t0.1296
1/34 depth 1: feed to 36 0 3 F100 t0.84
1/35 depth 1: feed to 36 0 -28.6981 F100 t19.0189
1/36 depth 1: feed to 36.4 0 -28.6981 F100 t0.24
1/37 depth 1: rapid to 36.4 0 3 t0.1268
1/38 depth 1: feed to 35 0 3 F100 t0.84
1/39 depth 1: feed to 35 0 -27.9979 F100 t18.5988
1/40 depth 1: feed to 35.4 0 -27.9979 F100 t0.24
1/41 depth 1: rapid to 35.4 0 3 t0.124
1/42 depth 1: feed to 34 0 3 F100 t0.84
1/43 depth 1: feed to 34 0 -27.2977 F100 t18.1786
1/44 depth 1: feed to 34.4 0 -27.2977 F100 t0.24
1/45 depth 1: rapid to 34.4 0 3 t0.1212
1/46 depth 1: feed to 33 0 3 F100 t0.84
1/47 depth 1: feed to 33 0 -26.5975 F100 t17.7585
1/48 depth 1: feed to 33.4 0 -26.5975 F100 t0.24
1/49 depth 1: rapid to 33.4 0 3 t0.1184
1/50 depth 1: feed to 32 0 3 F100 t0.84
1/51 depth 1: feed to 32 0 -25.8973 F100 t17.3384
1/52 depth 1: feed to 32.4 0 -25.8973 F100 t0.24
1/53 depth 1: rapid to 32.4 0 3 t0.1156
1/54 depth 1: feed to 31 0 3 F100 t0.84
1/55 depth 1: feed to 31 0 -25.1971 F100 t16.9183
1/56 depth 1: feed to 31.4 0 -25.1971 F100 t0.24
1/57 depth 1: rapid to 31.4 0 3 t0.1128
1/58 depth 1: feed to 30 0 3 F100 t0.84
1/59 depth 1: feed to 30 0 -24.4969 F100 t16.4981
1/60 depth 1: feed to 30.4 0 -24.4969 F100 t0.24
1/61 depth 1: rapid to 30.4 0 3 t0.11
1/62 depth 1: feed to 29 0 3 F100 t0.84
1/63 depth 1: feed to 29 0 -23.7967 F100 t16.078
1/64 depth 1: feed to 29.4 0 -23.7967 F100 t0.24
1/65 depth 1: rapid to 29.4 0 3 t0.1072
1/66 depth 1: feed to 28 0 3 F100 t0.84
1/67 depth 1: feed to 28 0 -23.0965 F100 t15.6579
1/68 depth 1: feed to 28.4 0 -23.0965 F100 t0.24
1/69 depth 1: rapid to 28.4 0 3 t0.1044
1/70 depth 1: feed to 27 0 3 F100 t0.84
1/71 depth 1: feed to 27 0 -22.3963 F100 t15.2378
1/72 depth 1: feed to 27.4 0 -22.3963 F100 t0.24
1/73 depth 1: rapid to 27.4 0 3 t0.1016
1/74 depth 1: feed to 26 0 3 F100 t0.84
1/75 depth 1: feed to 26 0 -21.6961 F100 t14.8176
1/76 depth 1: feed to 26.4 0 -21.6961 F100 t0.24
1/77 depth 1: rapid to 26.4 0 3 t0.0988
1/78 depth 1: feed to 25 0 3 F100 t0.84
1/79 depth 1: feed to 25 0 -20.9958 F100 t14.3975
1/80 depth 1: feed to 25.4 0 -20.9958 F100 t0.24
1/81 depth 1: rapid to 25.4 0 3 t0.096
1/82 depth 1: feed to 24 0 3 F100 t0.84
1/83 depth 1: feed to 24 0 -20.2956 F100 t13.9774
1/84 depth 1: feed to 24.4 0 -20.2956 F100 t0.24
1/85 depth 1: rapid to 24.4 0 3 t0.0932
1/86 depth 1: feed to 23 0 3 F100 t0.84
1/87 depth 1: feed to 23 0 -19.5954 F100 t13.5573
1/88 depth 1: feed to 23.4 0 -19.5954 F100 t0.24
1/89 depth 1: rapid to 23.4 0 3 t0.0904
1/90 depth 1: feed to 22 0 3 F100 t0.84
1/91 depth 1: feed to 22 0 -18.8952 F100 t13.1371
1/92 depth 1: feed to 22.4 0 -18.8952 F100 t0.24
1/93 depth 1: rapid to 22.4 0 3 t0.0876
1/94 depth 1: feed to 21 0 3 F100 t0.84
1/95 depth 1: feed to 21 0 -18.195 F100 t12.717
1/96 depth 1: feed to 21.4 0 -18.195 F100 t0.24
1/97 depth 1: rapid to 21.4 0 3 t0.0848
1/98 depth 1: feed to 20 0 3 F100 t0.84
1/99 depth 1: feed to 20 0 -17.4948 F100 t12.2969
1/100 depth 1: feed to 20.4 0 -17.4948 F100 t0.24
1/101 depth 1: rapid to 20.4 0 3 t0.082
1/102 depth 1: feed to 19 0 3 F100 t0.84
1/103 depth 1: feed to 19 0 -16.7946 F100 t11.8768
1/104 depth 1: feed to 19.4 0 -16.7946 F100 t0.24
1/105 depth 1: rapid to 19.4 0 3 t0.0792
1/106 depth 1: feed to 18 0 3 F100 t0.84
1/107 depth 1: feed to 18 0 -16.0944 F100 t11.4566
1/108 depth 1: feed to 18.4 0 -16.0944 F100 t0.24
1/109 depth 1: rapid to 18.4 0 3 t0.0764
1/110 depth 1: feed to 17 0 3 F100 t0.84
1/111 depth 1: feed to 17 0 -15.3942 F100 t11.0365
1/112 depth 1: feed to 17.4 0 -15.3942 F100 t0.24
1/113 depth 1: rapid to 17.4 0 3 t0.0736
1/114 depth 1: feed to 16 0 3 F100 t0.84
1/115 depth 1: feed to 16 0 -14.694 F100 t10.6164
1/116 depth 1: feed to 16.4 0 -14.694 F100 t0.24
1/117 depth 1: rapid to 16.4 0 3 t0.0708
1/118 depth 1: feed to 15 0 3 F100 t0.84
1/119 depth 1: feed to 15 0 -13.9938 F100 t10.1963
1/120 depth 1: feed to 15.4 0 -13.9938 F100 t0.24
1/121 depth 1: rapid to 15.4 0 3 t0.068
1/122 depth 1: feed to 14 0 3 F100 t0.84
1/123 depth 1: feed to 14 0 -13.2936 F100 t9.7761
1/124 depth 1: feed to 14.4 0 -13.2936 F100 t0.24
1/125 depth 1: rapid to 14.4 0 3 t0.0652
1/126 depth 1: feed to 13 0 3 F100 t0.84
1/127 depth 1: feed to 13 0 -12.5934 F100 t9.356
1/128 depth 1: feed to 13.4 0 -12.5934 F100 t0.24
1/129 depth 1: rapid to 13.4 0 3 t0.0624
1/130 depth 1: feed to 12 0 3 F100 t0.84
1/131 depth 1: feed to 12 0 -11.8932 F100 t8.9359
1/132 depth 1: feed to 12.4 0 -11.8932 F100 t0.24
1/133 depth 1: rapid to 12.4 0 3 t0.0596
1/134 depth 1: feed to 11 0 3 F100 t0.84
1/135 depth 1: feed to 11 0 -11.1929 F100 t8.5158
1/136 depth 1: feed to 11.4 0 -11.1929 F100 t0.24
1/137 depth 1: rapid to 11.4 0 3 t0.0568
1/138 depth 1: feed to 10 0 3 F100 t0.84
1/139 depth 1: feed to 10 0 -10.4927 F100 t8.0956
1/140 depth 1: feed to 10.4 0 -10.4927 F100 t0.24
1/141 depth 1: rapid to 10.4 0 3 t0.054
1/142 depth 1: feed to 9 0 3 F100 t0.84
1/143 depth 1: feed to 9 0 -9.7925 F100 t7.6755
1/144 depth 1: feed to 9.4 0 -9.7925 F100 t0.24
1/145 depth 1: rapid to 9.4 0 3 t0.0512
1/146 depth 1: feed to 8 0 3 F100 t0.84
1/147 depth 1: feed to 8 0 -9.0923 F100 t7.2554
1/148 depth 1: feed to 8.4 0 -9.0923 F100 t0.24
1/149 depth 1: rapid to 8.4 0 3 t0.0484
1/150 depth 1: feed to 7 0 3 F100 t0.84
1/151 depth 1: feed to 7 0 -8.3921 F100 t6.8353
1/152 depth 1: feed to 7.4 0 -8.3921 F100 t0.24
1/153 depth 1: rapid to 7.4 0 3 t0.0456
1/154 depth 1: feed to 6 0 3 F100 t0.84
1/155 depth 1: feed to 6 0 -7.6919 F100 t6.4151
1/156 depth 1: feed to 6.4 0 -7.6919 F100 t0.24
1/157 depth 1: rapid to 6.4 0 3 t0.0428
1/158 depth 1: feed to 5.7358 0 3 F100 t0.3985
1/159 depth 1: feed to 5.7358 0 -7.5069 F100 t6.3041
1/160 depth 1: feed to 6.1358 0 -7.5069 F100 t0.24
1/161 depth 1: rapid to 6.1358 0 3 t0.042
1/162 depth 1: feed to 4.7358 0 3 F100 t0.84
1/163 depth 1: feed to 4.7358 0 -6.8909 F100 t5.9345
1/164 depth 1: feed to 5.1358 0 -6.8909 F100 t0.24
1/165 depth 1: rapid to 5.1358 0 3 t0.0396
1/166 depth 1: feed to 3.7358 0 3 F100 t0.84
1/167 depth 1: feed to 3.7358 0 -6.4224 F100 t5.6534
1/168 depth 1: feed to 4.1358 0 -6.4224 F100 t0.24
1/169 depth 1: rapid to 4.1358 0 3 t0.0377
1/170 depth 1: feed to 2.7358 0 3 F100 t0.84
1/171 depth 1: feed to 2.7358 0 -6.0799 F100 t5.4479
1/172 depth 1: feed to 3.1358 0 -6.0799 F100 t0.24
1/173 depth 1: rapid to 3.1358 0 3 t0.0363
1/174 depth 1: feed to 1.7358 0 3 F100 t0.84
1/175 depth 1: feed to 1.7358 0 -5.8502 F100 t5.3101
1/176 depth 1: feed to 2.1358 0 -5.8502 F100 t0.24
1/177 depth 1: rapid to 2.1358 0 3 t0.0354
1/178 depth 1: feed to 0.7358 0 3 F100 t0.84
1/179 depth 1: feed to 0.7358 0 -5.7255 F100 t5.2353
1/180 depth 1: feed to 1.1358 0 -5.7255 F100 t0.24
1/181 depth 1: rapid to 1.1358 0 3 t0.0349
1/182 depth 1: feed to 0 0 3 F100 t0.6815
1/183 depth 1: feed to 0 0 -5.6984 F100 t5.219
1/184 depth 1: feed arc to 5.7358 0 -7.5069 center 0 0 -15.6984 normal 0 1 0 sweep 35 F100 t3.6652
1/185 depth 1: feed to 45 0 -35 F100 t28.7597
1/186 depth 1: rapid to 47 0 -35 t0.008
1/187 depth 1: rapid to 47 0 3 t0.152
5: rapid to 100 0 100 t0.388
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 188 motions, 0 errors, 0 warnings
