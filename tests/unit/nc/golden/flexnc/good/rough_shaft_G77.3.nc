=== about
Roughing of a shaft: G77.3A20X80Z12G27P2.5C2B2V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.2-G77.3 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G77.3A20X80Z12G27P2.5C2B2V0
G81X200Z100
M02
=== truth
42 0 2
37.5 0 2
37.5 0 -65.971789
37.9 0 -65.971789
37.9 0 2
35 0 2
35 0 -61.065263
35.4 0 -61.065263
35.4 0 2
32.5 0 2
32.5 0 -56.158736
32.9 0 -56.158736
32.9 0 2
30 0 2
30 0 -51.25221
30.4 0 -51.25221
30.4 0 2
27.5 0 2
27.5 0 -46.345684
27.9 0 -46.345684
27.9 0 2
25 0 2
25 0 -41.439158
25.4 0 -41.439158
25.4 0 2
22.5 0 2
22.5 0 -36.532631
22.9 0 -36.532631
22.9 0 2
20 0 2
20 0 -31.626105
20.4 0 -31.626105
20.4 0 2
17.5 0 2
17.5 0 -26.719579
17.9 0 -26.719579
17.9 0 2
15 0 2
15 0 -21.813053
15.4 0 -21.813053
15.4 0 2
12.5 0 2
12.5 0 -16.906526
12.9 0 -16.906526
12.9 0 2
10 0 2
10 0 -12
40 0 -70.878315
42 0 -70.878315
42 0 2
100 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G77.3 of line 4
1/1 depth 1: rapid from 100 0 50 to 42 0 2 t0.232
1/2 depth 1: feed to 37.5 0 2 F100 t2.7
1/3 depth 1: feed to 37.5 0 -65.9718 F100 t40.7831
1/4 depth 1: feed to 37.9 0 -65.9718 F100 t0.24
1/5 depth 1: rapid to 37.9 0 2 t0.2719
1/6 depth 1: feed to 35 0 2 F100 t1.74
1/7 depth 1: feed to 35 0 -61.0653 F100 t37.8392
1/8 depth 1: feed to 35.4 0 -61.0653 F100 t0.24
1/9 depth 1: rapid to 35.4 0 2 t0.2523
1/10 depth 1: feed to 32.5 0 2 F100 t1.74
1/11 depth 1: feed to 32.5 0 -56.1587 F100 t34.8952
1/12 depth 1: feed to 32.9 0 -56.1587 F100 t0.24
1/13 depth 1: rapid to 32.9 0 2 t0.2326
1/14 depth 1: feed to 30 0 2 F100 t1.74
1/15 depth 1: feed to 30 0 -51.2522 F100 t31.9513
1/16 depth 1: feed to 30.4 0 -51.2522 F100 t0.24
1/17 depth 1: rapid to 30.4 0 2 t0.213
1/18 depth 1: feed to 27.5 0 2 F100 t1.74
1/19 depth 1: feed to 27.5 0 -46.3457 F100 t29.0074
1/20 depth 1: feed to 27.9 0 -46.3457 F100 t0.24
1/21 depth 1: rapid to 27.9 0 2 t0.1934
1/22 depth 1: feed to 25 0 2 F100 t1.74
1/23 depth 1: feed to 25 0 -41.4392 F100 t26.0635
1/24 depth 1: feed to 25.4 0 -41.4392 F100 t0.24
1/25 depth 1: rapid to 25.4 0 2 t0.1738
1/26 depth 1: feed to 22.5 0 2 F100 t1.74
1/27 depth 1: feed to 22.5 0 -36.5326 F100 t23.1196
1/28 depth 1: feed to 22.9 0 -36.5326 F100 t0.24
1/29 depth 1: rapid to 22.9 0 2 t0.1541
1/30 depth 1: feed to 20 0 2 F100 t1.74
1/31 depth 1: feed to 20 0 -31.6261 F100 t20.1757
1/32 depth 1: feed to 20.4 0 -31.6261 F100 t0.24
1/33 depth 1: rapid to 20.4 0 2 t0.1345
1/34 depth 1: feed to 17.5 0 2 F100 t1.74
1/35 depth 1: feed to 17.5 0 -26.7196 F100 t17.2317
1/36 depth 1: feed to 17.9 0 -26.7196 F100 t0.24
1/37 depth 1: rapid to 17.9 0 2 t0.1149
1/38 depth 1: feed to 15 0 2 F100 t1.74
1/39 depth 1: feed to 15 0 -21.8131 F100 t14.2878
1/40 depth 1: feed to 15.4 0 -21.8131 F100 t0.24
1/41 depth 1: rapid to 15.4 0 2 t0.0953
1/42 depth 1: feed to 12.5 0 2 F100 t1.74
1/43 depth 1: feed to 12.5 0 -16.9065 F100 t11.3439
1/44 depth 1: feed to 12.9 0 -16.9065 F100 t0.24
1/45 depth 1: rapid to 12.9 0 2 t0.0756
1/46 depth 1: feed to 10 0 2 F100 t1.74
1/47 depth 1: feed to 10 0 -12 F100 t8.4
1/48 depth 1: feed to 40 0 -70.8783 F100 t39.6484
1/49 depth 1: rapid to 42 0 -70.8783 t0.008
1/50 depth 1: rapid to 42 0 2 t0.2915
5: rapid to 100 0 100 t0.392
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 51 motions, 0 errors, 0 warnings
