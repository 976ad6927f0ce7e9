=== about
Roughing of a hole: G12X60R20Z10P1.5C-2B2V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.3-G12 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G12X60R20Z10P1.5C-2B2V0
G81X200Z100
M02
=== truth
28 0 2
31.5 0 2
31.5 0 -22.400658
31.1 0 -22.400658
31.1 0 2
33 0 2
33 0 -19.464346
32.6 0 -19.464346
32.6 0 2
34.5 0 2
34.5 0 -17.360775
34.1 0 -17.360775
34.1 0 2
36 0 2
36 0 -15.717143
35.6 0 -15.717143
35.6 0 2
37.5 0 2
37.5 0 -14.387505
37.1 0 -14.387505
37.1 0 2
39 0 2
39 0 -13.296707
38.6 0 -13.296707
38.6 0 2
40.5 0 2
40.5 0 -12.400284
40.1 0 -12.400284
40.1 0 2
42 0 2
42 0 -11.669697
41.6 0 -11.669697
41.6 0 2
43.5 0 2
43.5 0 -11.08572
43.1 0 -11.08572
43.1 0 2
45 0 2
45 0 -10.635083
44.6 0 -10.635083
44.6 0 2
46.5 0 2
46.5 0 -10.308631
46.1 0 -10.308631
46.1 0 2
48 0 2
48 0 -10.100251
47.6 0 -10.100251
47.6 0 2
49.5 0 2
49.5 0 -10.006251
49.1 0 -10.006251
49.1 0 2
50 0 2
50 0 -10
30 0 -30 center 50 0 -30 sweep -90
30 0 2
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G12 of line 4
1/1 depth 1: rapid from 100 0 50 to 28 0 2 t0.288
1/2 depth 1: feed to 31.5 0 2 F100 t2.1
1/3 depth 1: feed to 31.5 0 -22.4007 F100 t14.6404
1/4 depth 1: feed to 31.1 0 -22.4007 F100 t0.24
1/5 depth 1: rapid to 31.1 0 2 t0.0976
1/6 depth 1: feed to 33 0 2 F100 t1.14
1/7 depth 1: feed to 33 0 -19.4643 F100 t12.8786
1/8 depth 1: feed to 32.6 0 -19.4643 F100 t0.24
1/9 depth 1: rapid to 32.6 0 2 t0.0859
1/10 depth 1: feed to 34.5 0 2 F100 t1.14
1/11 depth 1: feed to 34.5 0 -17.3608 F100 t11.6165
1/12 depth 1: feed to 34.1 0 -17.3608 F100 t0.24
1/13 depth 1: rapid to 34.1 0 2 t0.0774
1/14 depth 1: feed to 36 0 2 F100 t1.14
1/15 depth 1: feed to 36 0 -15.7171 F100 t10.6303
1/16 depth 1: feed to 35.6 0 -15.7171 F100 t0.24
1/17 depth 1: rapid to 35.6 0 2 t0.0709
1/18 depth 1: feed to 37.5 0 2 F100 t1.14
1/19 depth 1: feed to 37.5 0 -14.3875 F100 t9.8325
1/20 depth 1: feed to 37.1 0 -14.3875 F100 t0.24
1/21 depth 1: rapid to 37.1 0 2 t0.0656
1/22 depth 1: feed to 39 0 2 F100 t1.14
1/23 depth 1: feed to 39 0 -13.2967 F100 t9.178
1/24 depth 1: feed to 38.6 0 -13.2967 F100 t0.24
1/25 depth 1: rapid to 38.6 0 2 t0.0612
1/26 depth 1: feed to 40.5 0 2 F100 t1.14
1/27 depth 1: feed to 40.5 0 -12.4003 F100 t8.6402
1/28 depth 1: feed to 40.1 0 -12.4003 F100 t0.24
1/29 depth 1: rapid to 40.1 0 2 t0.0576
1/30 depth 1: feed to 42 0 2 F100 t1.14
1/31 depth 1: feed to 42 0 -11.6697 F100 t8.2018
1/32 depth 1: feed to 41.6 0 -11.6697 F100 t0.24
1/33 depth 1: rapid to 41.6 0 2 t0.0547
1/34 depth 1: feed to 43.5 0 2 F100 t1.14
1/35 depth 1: feed to 43.5 0 -11.0857 F100 t7.8514
1/36 depth 1: feed to 43.1 0 -11.0857 F100 t0.24
1/37 depth 1: rapid to 43.1 0 2 t0.0523
1/38 depth 1: feed to 45 0 2 F100 t1.14
1/39 depth 1: feed to 45 0 -10.6351 F100 t7.581
1/40 depth 1: feed to 44.6 0 -10.6351 F100 t0.24
1/41 depth 1: rapid to 44.6 0 2 t0.0505
1/42 depth 1: feed to 46.5 0 2 F100 t1.14
1/43 depth 1: feed to 46.5 0 -10.3086 F100 t7.3852
1/44 depth 1: feed to 46.1 0 -10.3086 F100 t0.24
1/45 depth 1: rapid to 46.1 0 2 t0.0492
1/46 depth 1: feed to 48 0 2 F100 t1.14
1/47 depth 1: feed to 48 0 -10.1003 F100 t7.2602
1/48 depth 1: feed to 47.6 0 -10.1003 F100 t0.24
1/49 depth 1: rapid to 47.6 0 2 t0.0484
1/50 depth 1: feed to 49.5 0 2 F100 t1.14
1/51 depth 1: feed to 49.5 0 -10.0063 F100 t7.2038
1/52 depth 1: feed to 49.1 0 -10.0063 F100 t0.24
1/53 depth 1: rapid to 49.1 0 2 t0.048
1/54 depth 1: feed to 50 0 2 F100 t0.54
1/55 depth 1: feed to 50 0 -10 F100 t7.2
1/56 depth 1: feed arc to 30 0 -30 center 50 0 -30 normal 0 1 0 sweep -90 F100 t18.8496
1/57 depth 1: rapid to 30 0 2 t0.128
5: rapid to 100 0 100 t0.392
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 58 motions, 0 errors, 0 warnings
