=== about
Roughing of a shaft: G22.1X100Y40Z0G30R0U0P2B2C2V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.2-G22.1 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G22.1X100Y40Z0G30R0U0P2B2C2V0
G81X200Z100
M02
=== truth
52 0 2
48 0 2
48 0 -36.535898
48.4 0 -36.535898
48.4 0 2
46 0 2
46 0 -33.071797
46.4 0 -33.071797
46.4 0 2
44 0 2
44 0 -29.607695
44.4 0 -29.607695
44.4 0 2
42 0 2
42 0 -26.143594
42.4 0 -26.143594
42.4 0 2
40 0 2
40 0 -22.679492
40.4 0 -22.679492
40.4 0 2
38 0 2
38 0 -19.21539
38.4 0 -19.21539
38.4 0 2
36 0 2
36 0 -15.751289
36.4 0 -15.751289
36.4 0 2
34 0 2
34 0 -12.287187
34.4 0 -12.287187
34.4 0 2
32 0 2
32 0 -8.823085
32.4 0 -8.823085
32.4 0 2
30 0 2
30 0 -5.358984
30.4 0 -5.358984
30.4 0 2
28 0 2
28 0 -1.894882
28.4 0 -1.894882
28.4 0 2
26.905989 0 2
26.905989 0 0
50 0 -40
52 0 -40
52 0 2
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G22.1 of line 4
1/1 depth 1: rapid from 100 0 50 to 52 0 2 t0.192
1/2 depth 1: feed to 48 0 2 F100 t2.4
1/3 depth 1: feed to 48 0 -36.5359 F100 t23.1215
1/4 depth 1: feed to 48.4 0 -36.5359 F100 t0.24
1/5 depth 1: rapid to 48.4 0 2 t0.1541
1/6 depth 1: feed to 46 0 2 F100 t1.44
1/7 depth 1: feed to 46 0 -33.0718 F100 t21.0431
1/8 depth 1: feed to 46.4 0 -33.0718 F100 t0.24
1/9 depth 1: rapid to 46.4 0 2 t0.1403
1/10 depth 1: feed to 44 0 2 F100 t1.44
1/11 depth 1: feed to 44 0 -29.6077 F100 t18.9646
1/12 depth 1: feed to 44.4 0 -29.6077 F100 t0.24
1/13 depth 1: rapid to 44.4 0 2 t0.1264
1/14 depth 1: feed to 42 0 2 F100 t1.44
1/15 depth 1: feed to 42 0 -26.1436 F100 t16.8862
1/16 depth 1: feed to 42.4 0 -26.1436 F100 t0.24
1/17 depth 1: rapid to 42.4 0 2 t0.1126
1/18 depth 1: feed to 40 0 2 F100 t1.44
1/19 depth 1: feed to 40 0 -22.6795 F100 t14.8077
1/20 depth 1: feed to 40.4 0 -22.6795 F100 t0.24
1/21 depth 1: rapid to 40.4 0 2 t0.0987
1/22 depth 1: feed to 38 0 2 F100 t1.44
1/23 depth 1: feed to 38 0 -19.2154 F100 t12.7292
1/24 depth 1: feed to 38.4 0 -19.2154 F100 t0.24
1/25 depth 1: rapid to 38.4 0 2 t0.0849
1/26 depth 1: feed to 36 0 2 F100 t1.44
1/27 depth 1: feed to 36 0 -15.7513 F100 t10.6508
1/28 depth 1: feed to 36.4 0 -15.7513 F100 t0.24
1/29 depth 1: rapid to 36.4 0 2 t0.071
1/30 depth 1: feed to 34 0 2 F100 t1.44
1/31 depth 1: feed to 34 0 -12.2872 F100 t8.5723
1/32 depth 1: feed to 34.4 0 -12.2872 F100 t0.24
1/33 depth 1: rapid to 34.4 0 2 t0.0571
1/34 depth 1: feed to 32 0 2 F100 t1.44
1/35 depth 1: feed to 32 0 -8.8231 F100 t6.4939
1/36 depth 1: feed to 32.4 0 -8.8231 F100 t0.24
1/37 depth 1: rapid to 32.4 0 2 t0.0433
1/38 depth 1: feed to 30 0 2 F100 t1.44
1/39 depth 1: feed to 30 0 -5.359 F100 t4.4154
1/40 depth 1: feed to 30.4 0 -5.359 F100 t0.24
1/41 depth 1: rapid to 30.4 0 2 t0.0294
1/42 depth 1: feed to 28 0 2 F100 t1.44
1/43 depth 1: feed to 28 0 -1.8949 F100 t2.3369
1/44 depth 1: feed to 28.4 0 -1.8949 F100 t0.24
1/45 depth 1: rapid to 28.4 0 2 t0.0156
1/46 depth 1: feed to 26.906 0 2 F100 t0.8964
1/47 depth 1: feed to 26.906 0 0 F100 t1.2
1/48 depth 1: feed to 50 0 -40 F100 t27.7128
1/49 depth 1: rapid to 52 0 -40 t0.008
1/50 depth 1: rapid to 52 0 2 t0.168
5: rapid to 100 0 100 t0.392
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 51 motions, 0 errors, 0 warnings
