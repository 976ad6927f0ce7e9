=== about
Digest wl4, 4.5 and 4.6: G32 whose pitch stays in the sequence, G33 there and back with the spindle reversed, a growing pitch. The overrides of the panel are at 100 per cent always.
proves: wl4-5.1.5-G32 wl4-5.1.6-G33 wl4-4.2-P wl4-4.2-F wl4-7.1-ovr
=== settings
control = wl4-lathe
=== main
%THREADS
G54 G97 S600 M3
G0 X20 Z5
G32 Z-25 F2
G9 Z-35 F3
G0 Z5
G33 Z-15 F1.5
G0 X30
G32 Z-25 F2 I1
G0 X0
M30
%
=== truth
rapid 10 0 5
thread 10 0 -25 F 1200 t 1.5 start 0
thread 10 0 -35 F 1200 t 0.5 start 0
rapid 10 0 5
thread 10 0 -15 F 900
thread 10 0 5 F 900
rapid 15 0 5
thread 15 0 -25 t 0.6390 change 1
rapid 0 0 -25
=== expect
file 0 main.nc
2: event spindle rpm=600 direction="cw"
3: rapid from 0 0 0 to 10 0 5 t0.04
4: thread to 10 0 -25 F1200 t1.5
5: thread to 10 0 -35 F1200 t0.5
6: rapid to 10 0 5 t0.16
7: thread to 10 0 -15 F900 t1.3333
7: event spindle rpm=600 direction="ccw"
7: thread to 10 0 5 F900 t1.3333 start 240
7: event spindle rpm=600 direction="cw"
8: rapid to 15 0 5 t0.02
9: thread to 15 0 -25 F2816.9601 t0.639 change 1
10: rapid to 0 0 -25 t0.06
11: event end code="M30"
end of program: 10 blocks, 9 motions, 0 errors, 0 warnings
