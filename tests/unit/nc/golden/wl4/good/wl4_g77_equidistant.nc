=== about
Digest wl4, 10.5, TEST_G77: roughing with 0.5 all around, two finishing passes.
proves: wl4-11.9.2-G77 wl4-11.9.3-G77 wl4-7.3-TM6 wl4-7.4-M6 wl4-9.2-200 wl4-4.2-T
=== settings
control = wl4-lathe
=== main
%TEST_G77
G54 G95
N10 G0 Z100
N11 T1 M6
N12 G0 X10 Z40
N13 G77 G41 G0 X2 Z45 P120 Q124 R0.5 E2 F0.7 S500 M3
N14 G0 Z100
N15 T2 M6
N16 G0 X10 Z40
N11 G77 G41 G0 X2 Z45 P120 Q124 R0.2 F0.3 S800
N12 G77 G41 G0 X2 Z45 P120 Q124 F0.3 S800
X#200
M2
N120 G1 Z35
N121 G2 X5 Z25 R10
N122 G3 X7 Z20 R8
N123 G1 X8.5 Z18
N124 Z5
%
=== truth
rapid 0 0 100
rapid 5 0 40
rapid 5 0 45
rapid 3 0 45
feed 3 0 32.5356
feed 3 0 24.9048 center -6.7823 0 28.7202
feed 3 0 23.0065
feed 3.9335 0 20.2492 center 10.4356 0 23.9871
feed 3.9682 0 20.1756 center 3.5 0 20
feed 4.7182 0 18.1756
feed 4.75 0 18 center 4.25 0 18
feed 4.75 0 5
rapid 5 0 5
rapid 5 0 45
rapid 3 0 45
rapid 1.5 0 45
feed 1.5 0 35.1742
feed 3 0 32.5356 center -6.7823 0 28.7202
rapid 5 0 32.5356
rapid 5 0 24.9048
rapid 3 0 24.9048
feed 2.9884 0 24.8751 center -6.7823 0 28.7202
feed 3 0 23.0065 center 10.4356 0 23.9871
rapid 5 0 23.0065
rapid 5 0 40
rapid 5 0 100
rapid 5 0 40
rapid 5 0 45
rapid 1.2 0 45
feed 1.2 0 35.0702
feed 2.6952 0 24.9496 center -6.7823 0 28.7202
feed 3.6734 0 20.0997 center 10.4356 0 23.9871
feed 3.6873 0 20.0702 center 3.5 0 20
feed 4.4373 0 18.0702
feed 4.45 0 18 center 4.25 0 18
feed 4.45 0 5
rapid 5 0 5
rapid 5 0 40
rapid 5 0 45
rapid 1 0 45
feed 1 0 35
feed 2.5 0 25 center -6.7823 0 28.7202
feed 3.5 0 20 center 10.4356 0 23.9871
feed 4.25 0 18
feed 4.25 0 5
rapid 5 0 5
rapid 5 0 40
rapid 1 0 40
=== expect
file 0 main.nc
3 N10: rapid from 0 0 0 to 0 0 100 t0.4
4 N11: event tool tool=1
5 N12: rapid to 5 0 40 t0.24
6 N13: event spindle rpm=500 direction="cw"
6 N13: rapid to 5 0 45 t0.02
6 N13: rapid to 3 0 45 t0.008
6 N13: feed to 3 0 32.5356 F350 t2.1368
6 N13: feed arc to 3 0 24.9048 center -6.7823 0 28.7202 normal 0 1 0 sweep 42.6149 F350 t1.3388
6 N13: feed to 3 0 23.0065 F350 t0.3254
6 N13: feed arc to 3.9335 0 20.2492 center 10.4356 0 23.9871 normal 0 1 0 sweep -22.381 F350 t0.5022
6 N13: feed arc to 3.9682 0 20.1756 center 3.5 0 20 normal 0 1 0 sweep 9.3375 F350 t0.014
6 N13: feed to 4.7182 0 18.1756 F350 t0.3662
6 N13: feed arc to 4.75 0 18 center 4.25 0 18 normal 0 1 0 sweep 20.556 F350 t0.0308
6 N13: feed to 4.75 0 5 F350 t2.2286
6 N13: rapid to 5 0 5 t0.001
6 N13: rapid to 5 0 45 t0.16
6 N13: rapid to 3 0 45 t0.008
6 N13: rapid to 1.5 0 45 t0.006
6 N13: feed to 1.5 0 35.1742 F350 t1.6844
6 N13: feed arc to 3 0 32.5356 center -6.7823 0 28.7202 normal 0 1 0 sweep 16.6203 F350 t0.5221
6 N13: rapid to 5 0 32.5356 t0.008
6 N13: rapid to 5 0 24.9048 t0.0305
6 N13: rapid to 3 0 24.9048 t0.008
6 N13: feed arc to 2.9884 0 24.8751 center -6.7823 0 28.7202 normal 0 1 0 sweep 0.174 F350 t0.0055
6 N13: feed arc to 3 0 23.0065 center 10.4356 0 23.9871 normal 0 1 0 sweep -14.3119 F350 t0.3212
6 N13: rapid to 5 0 23.0065 t0.008
6 N13: rapid to 5 0 40 t0.068
7 N14: rapid to 5 0 100 t0.24
8 N15: event tool tool=2
9 N16: rapid to 5 0 40 t0.24
10 N11: event spindle rpm=800 direction="cw"
10 N11: rapid to 5 0 45 t0.02
10 N11: rapid to 1.2 0 45 t0.0152
10 N11: feed to 1.2 0 35.0702 F240 t2.4824
10 N11: feed arc to 2.6952 0 24.9496 center -6.7823 0 28.7202 normal 0 1 0 sweep 60.1979 F240 t2.6792
10 N11: feed arc to 3.6734 0 20.0997 center 10.4356 0 23.9871 normal 0 1 0 sweep -36.9816 F240 t1.2586
10 N11: feed arc to 3.6873 0 20.0702 center 3.5 0 20 normal 0 1 0 sweep 9.3375 F240 t0.0081
10 N11: feed to 4.4373 0 18.0702 F240 t0.534
10 N11: feed arc to 4.45 0 18 center 4.25 0 18 normal 0 1 0 sweep 20.556 F240 t0.0179
10 N11: feed to 4.45 0 5 F240 t3.25
10 N11: rapid to 5 0 5 t0.0022
10 N11: rapid to 5 0 40 t0.14
11 N12: rapid to 5 0 45 t0.02
11 N12: rapid to 1 0 45 t0.016
11 N12: feed to 1 0 35 F240 t2.5
11 N12: feed arc to 2.5 0 25 center -6.7823 0 28.7202 normal 0 1 0 sweep 60.7415 F240 t2.6503
11 N12: feed arc to 3.5 0 20 center 10.4356 0 23.9871 normal 0 1 0 sweep -37.1673 F240 t1.2974
11 N12: feed to 4.25 0 18 F240 t0.534
11 N12: feed to 4.25 0 5 F240 t3.25
11 N12: rapid to 5 0 5 t0.003
11 N12: rapid to 5 0 40 t0.14
12: rapid to 1 0 40 t0.016
13: event end code="M2"
end of program: 12 blocks, 48 motions, 0 errors, 0 warnings
