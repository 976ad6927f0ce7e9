=== about
Roughing of a shaft: G8.1X79A26Z4R14U17P2C2B2V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.2-G8.1 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G8.1X79A26Z4R14U17P2C2B2V0
G81X200Z100
M02
=== truth
41.5 0 2
37.5 0 2
37.5 0 -18.796235
37.9 0 -18.796235
37.9 0 2
35.5 0 2
35.5 0 -18.437004
35.9 0 -18.437004
35.9 0 2
33.5 0 2
33.5 0 -17.820266
33.9 0 -17.820266
33.9 0 2
31.5 0 2
31.5 0 -16.914292
31.9 0 -16.914292
31.9 0 2
29.5 0 2
29.5 0 -15.662019
29.9 0 -15.662019
29.9 0 2
27.5 0 2
27.5 0 -13.955887
27.9 0 -13.955887
27.9 0 2
25.5 0 2
25.5 0 -11.557943
25.9 0 -11.557943
25.9 0 2
24.967742 0 2
24.967742 0 -10.735487
25.367742 0 -10.735487
25.367742 0 2
22.967742 0 2
22.967742 0 -8.169226
23.367742 0 -8.169226
23.367742 0 2
20.967742 0 2
20.967742 0 -6.48848
21.367742 0 -6.48848
21.367742 0 2
18.967742 0 2
18.967742 0 -5.335638
19.367742 0 -5.335638
19.367742 0 2
16.967742 0 2
16.967742 0 -4.574017
17.367742 0 -4.574017
17.367742 0 2
14.967742 0 2
14.967742 0 -4.138976
15.367742 0 -4.138976
15.367742 0 2
13 0 2
13 0 -4
24.967742 0 -10.735487 center 13 0 -18 sweep 58.741921
39.5 0 -18.914292 center 39.5 0 -1.914292 sweep -58.741921
41.5 0 -18.914292
41.5 0 2
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G8.1 of line 4
1/1 depth 1: rapid from 100 0 50 to 41.5 0 2 t0.234
1/2 depth 1: feed to 37.5 0 2 F100 t2.4
1/3 depth 1: feed to 37.5 0 -18.7962 F100 t12.4777
1/4 depth 1: feed to 37.9 0 -18.7962 F100 t0.24
1/5 depth 1: rapid to 37.9 0 2 t0.0832
1/6 depth 1: feed to 35.5 0 2 F100 t1.44
1/7 depth 1: feed to 35.5 0 -18.437 F100 t12.2622
1/8 depth 1: feed to 35.9 0 -18.437 F100 t0.24
1/9 depth 1: rapid to 35.9 0 2 t0.0817
1/10 depth 1: feed to 33.5 0 2 F100 t1.44
1/11 depth 1: feed to 33.5 0 -17.8203 F100 t11.8922
1/12 depth 1: feed to 33.9 0 -17.8203 F100 t0.24
1/13 depth 1: rapid to 33.9 0 2 t0.0793
1/14 depth 1: feed to 31.5 0 2 F100 t1.44
1/15 depth 1: feed to 31.5 0 -16.9143 F100 t11.3486
1/16 depth 1: feed to 31.9 0 -16.9143 F100 t0.24
1/17 depth 1: rapid to 31.9 0 2 t0.0757
1/18 depth 1: feed to 29.5 0 2 F100 t1.44
1/19 depth 1: feed to 29.5 0 -15.662 F100 t10.5972
1/20 depth 1: feed to 29.9 0 -15.662 F100 t0.24
1/21 depth 1: rapid to 29.9 0 2 t0.0706
1/22 depth 1: feed to 27.5 0 2 F100 t1.44
1/23 depth 1: feed to 27.5 0 -13.9559 F100 t9.5735
1/24 depth 1: feed to 27.9 0 -13.9559 F100 t0.24
1/25 depth 1: rapid to 27.9 0 2 t0.0638
1/26 depth 1: feed to 25.5 0 2 F100 t1.44
1/27 depth 1: feed to 25.5 0 -11.5579 F100 t8.1348
1/28 depth 1: feed to 25.9 0 -11.5579 F100 t0.24
1/29 depth 1: rapid to 25.9 0 2 t0.0542
1/30 depth 1: feed to 24.9677 0 2 F100 t0.5594
1/31 depth 1: feed to 24.9677 0 -10.7355 F100 t7.6413
1/32 depth 1: feed to 25.3677 0 -10.7355 F100 t0.24
1/33 depth 1: rapid to 25.3677 0 2 t0.0509
1/34 depth 1: feed to 22.9677 0 2 F100 t1.44
1/35 depth 1: feed to 22.9677 0 -8.1692 F100 t6.1015
1/36 depth 1: feed to 23.3677 0 -8.1692 F100 t0.24
1/37 depth 1: rapid to 23.3677 0 2 t0.0407
1/38 depth 1: feed to 20.9677 0 2 F100 t1.44
1/39 depth 1: feed to 20.9677 0 -6.4885 F100 t5.0931
1/40 depth 1: feed to 21.3677 0 -6.4885 F100 t0.24
1/41 depth 1: rapid to 21.3677 0 2 t0.034
1/42 depth 1: feed to 18.9677 0 2 F100 t1.44
1/43 depth 1: feed to 18.9677 0 -5.3356 F100 t4.4014
1/44 depth 1: feed to 19.3677 0 -5.3356 F100 t0.24
1/45 depth 1: rapid to 19.3677 0 2 t0.0293
1/46 depth 1: feed to 16.9677 0 2 F100 t1.44
1/47 depth 1: feed to 16.9677 0 -4.574 F100 t3.9444
1/48 depth 1: feed to 17.3677 0 -4.574 F100 t0.24
1/49 depth 1: rapid to 17.3677 0 2 t0.0263
1/50 depth 1: feed to 14.9677 0 2 F100 t1.44
1/51 depth 1: feed to 14.9677 0 -4.139 F100 t3.6834
1/52 depth 1: feed to 15.3677 0 -4.139 F100 t0.24
1/53 depth 1: rapid to 15.3677 0 2 t0.0246
1/54 depth 1: feed to 13 0 2 F100 t1.4206
1/55 depth 1: feed to 13 0 -4 F100 t3.6
1/56 depth 1: feed arc to 24.9677 0 -10.7355 center 13 0 -18 normal 0 1 0 sweep 58.7419 F100 t8.612
1/57 depth 1: feed arc to 39.5 0 -18.9143 center 39.5 0 -1.9143 normal 0 1 0 sweep -58.7419 F100 t10.4574
1/58 depth 1: rapid to 41.5 0 -18.9143 t0.008
1/59 depth 1: rapid to 41.5 0 2 t0.0837
5: rapid to 100 0 100 t0.392
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 60 motions, 0 errors, 0 warnings
