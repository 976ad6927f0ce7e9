=== about
Digest wl4, 10.5, TEST_G77_1: allowances I and K, a closed zone. F of contour blocks is ignored.
proves: wl4-11.9.1-G77 wl4-11-ts wl4-4.2-Q wl4-4.2-P
=== settings
control = wl4-lathe
=== main
%TEST_G77_1
G54 G95
N9 G0 X10 Z40
N10 G77 G0 X2 Z45 P120 Q124 I0.5 K0.5 E2 F0.7 S500 M3
M2
N120 G1 Z35 F0.3
N121 G2 X5 Z25 R10
N122 G3 X7 Z20 R8
N123 G1 X8.5 Z18
N124 Z5
%
=== truth
rapid 5 0 40
rapid 5 0 45.5
rapid 3 0 45.5
feed 3 0 32.9403 F 350
feed 3 0 25.5 center -6.2823 0 29.2202
feed 3 0 23.4742
feed 4 0 20.5 center 10.9356 0 24.4871
feed 4.75 0 18.5
feed 4.75 0 5.5
rapid 5 0 5.5
rapid 5 0 45.5
rapid 3 0 45.5
rapid 1.5 0 45.5
feed 1.5 0 35.5
feed 3 0 32.9403 center -6.2823 0 29.2202
rapid 5 0 32.9403
rapid 5 0 25.5
rapid 3 0 25.5
feed 3 0 23.4742 center 10.9356 0 24.4871
rapid 5 0 23.4742
rapid 5 0 40
=== expect
file 0 main.nc
3 N9: rapid from 0 0 0 to 5 0 40 t0.16
4 N10: event spindle rpm=500 direction="cw"
4 N10: rapid to 5 0 45.5 t0.022
4 N10: rapid to 3 0 45.5 t0.008
4 N10: feed to 3 0 32.9403 F350 t2.1531
4 N10: feed arc to 3 0 25.5 center -6.2823 0 29.2202 normal 0 1 0 sweep 43.68 F350 t1.3069
4 N10: feed to 3 0 23.4742 F350 t0.3473
4 N10: feed arc to 4 0 20.5 center 10.9356 0 24.4871 normal 0 1 0 sweep -22.6199 F350 t0.5414
4 N10: feed to 4.75 0 18.5 F350 t0.3662
4 N10: feed to 4.75 0 5.5 F350 t2.2286
4 N10: rapid to 5 0 5.5 t0.001
4 N10: rapid to 5 0 45.5 t0.16
4 N10: rapid to 3 0 45.5 t0.008
4 N10: rapid to 1.5 0 45.5 t0.006
4 N10: feed to 1.5 0 35.5 F350 t1.7143
4 N10: feed arc to 3 0 32.9403 center -6.2823 0 29.2202 normal 0 1 0 sweep 17.0615 F350 t0.5105
4 N10: rapid to 5 0 32.9403 t0.008
4 N10: rapid to 5 0 25.5 t0.0298
4 N10: rapid to 3 0 25.5 t0.008
4 N10: feed arc to 3 0 23.4742 center 10.9356 0 24.4871 normal 0 1 0 sweep -14.5474 F350 t0.3482
4 N10: rapid to 5 0 23.4742 t0.008
4 N10: rapid to 5 0 40 t0.0661
5: event end code="M2"
end of program: 4 blocks, 21 motions, 0 errors, 0 warnings
