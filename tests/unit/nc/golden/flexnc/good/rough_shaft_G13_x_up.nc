=== about
Roughing of a shaft: G13X70R18Z0P1.5C2B2V0. Points, centres and pass ends from the formulas of the digest, made apart
from the control.
proves: fnc-3.2-G13 fnc-3.1-rough fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-C5
=== settings
control = flexnc
start = 100 0 50
param.arc_view = 1
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
33.5 0 -10.806253
33.9 0 -10.806253
33.9 0 2
32 0 2
32 0 -8.050126
32.4 0 -8.050126
32.4 0 2
30.5 0 2
30.5 0 -6.094119
30.9 0 -6.094119
30.9 0 2
29 0 2
29 0 -4.583592
29.4 0 -4.583592
29.4 0 2
27.5 0 2
27.5 0 -3.379808
27.9 0 -3.379808
27.9 0 2
26 0 2
26 0 -2.411543
26.4 0 -2.411543
26.4 0 2
24.5 0 2
24.5 0 -1.636932
24.9 0 -1.636932
24.9 0 2
23 0 2
23 0 -1.029437
23.4 0 -1.029437
23.4 0 2
21.5 0 2
21.5 0 -0.571575
21.9 0 -0.571575
21.9 0 2
20 0 2
20 0 -0.251761
20.4 0 -0.251761
20.4 0 2
18.5 0 2
18.5 0 -0.062609
18.9 0 -0.062609
18.9 0 2
17 0 2
17 0 0
35 0 -18 center 17 0 -18 sweep 90
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
1/3 depth 1: feed to 33.5 0 -10.8063 F100 t7.6838
1/4 depth 1: feed to 33.9 0 -10.8063 F100 t0.24
1/5 depth 1: rapid to 33.9 0 2 t0.0512
1/6 depth 1: feed to 32 0 2 F100 t1.14
1/7 depth 1: feed to 32 0 -8.0501 F100 t6.0301
1/8 depth 1: feed to 32.4 0 -8.0501 F100 t0.24
1/9 depth 1: rapid to 32.4 0 2 t0.0402
1/10 depth 1: feed to 30.5 0 2 F100 t1.14
1/11 depth 1: feed to 30.5 0 -6.0941 F100 t4.8565
1/12 depth 1: feed to 30.9 0 -6.0941 F100 t0.24
1/13 depth 1: rapid to 30.9 0 2 t0.0324
1/14 depth 1: feed to 29 0 2 F100 t1.14
1/15 depth 1: feed to 29 0 -4.5836 F100 t3.9502
1/16 depth 1: feed to 29.4 0 -4.5836 F100 t0.24
1/17 depth 1: rapid to 29.4 0 2 t0.0263
1/18 depth 1: feed to 27.5 0 2 F100 t1.14
1/19 depth 1: feed to 27.5 0 -3.3798 F100 t3.2279
1/20 depth 1: feed to 27.9 0 -3.3798 F100 t0.24
1/21 depth 1: rapid to 27.9 0 2 t0.0215
1/22 depth 1: feed to 26 0 2 F100 t1.14
1/23 depth 1: feed to 26 0 -2.4115 F100 t2.6469
1/24 depth 1: feed to 26.4 0 -2.4115 F100 t0.24
1/25 depth 1: rapid to 26.4 0 2 t0.0176
1/26 depth 1: feed to 24.5 0 2 F100 t1.14
1/27 depth 1: feed to 24.5 0 -1.6369 F100 t2.1822
1/28 depth 1: feed to 24.9 0 -1.6369 F100 t0.24
1/29 depth 1: rapid to 24.9 0 2 t0.0145
1/30 depth 1: feed to 23 0 2 F100 t1.14
1/31 depth 1: feed to 23 0 -1.0294 F100 t1.8177
1/32 depth 1: feed to 23.4 0 -1.0294 F100 t0.24
1/33 depth 1: rapid to 23.4 0 2 t0.0121
1/34 depth 1: feed to 21.5 0 2 F100 t1.14
1/35 depth 1: feed to 21.5 0 -0.5716 F100 t1.5429
1/36 depth 1: feed to 21.9 0 -0.5716 F100 t0.24
1/37 depth 1: rapid to 21.9 0 2 t0.0103
1/38 depth 1: feed to 20 0 2 F100 t1.14
1/39 depth 1: feed to 20 0 -0.2518 F100 t1.3511
1/40 depth 1: feed to 20.4 0 -0.2518 F100 t0.24
1/41 depth 1: rapid to 20.4 0 2 t0.009
1/42 depth 1: feed to 18.5 0 2 F100 t1.14
1/43 depth 1: feed to 18.5 0 -0.0626 F100 t1.2376
1/44 depth 1: feed to 18.9 0 -0.0626 F100 t0.24
1/45 depth 1: rapid to 18.9 0 2 t0.0083
1/46 depth 1: feed to 17 0 2 F100 t1.14
1/47 depth 1: feed to 17 0 0 F100 t1.2
1/48 depth 1: feed arc to 35 0 -18 center 17 0 -18 normal 0 1 0 sweep 90 F100 t16.9646
1/49 depth 1: rapid to 37 0 -18 t0.008
1/50 depth 1: rapid to 37 0 2 t0.08
5: rapid to 100 0 100 t0.392
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 51 motions, 0 errors, 0 warnings
