=== about
Digest wl4, 9.4, worked example 1: nine passes.
proves: wl4-11.1-G31 wl4-11.13-pgm wl4-11-open wl4-9.2-108 wl4-9.2-130 wl4-9.2-131 wl4-9.2-134 wl4-9.2-135 wl4-9.2-104 wl4-9.2-136 wl4-9.2-140 wl4-4.4-dot wl4-5.1.5-G32
=== settings
control = wl4-lathe
=== main
%THREAD
G54 G97 S500 M3
G0 X66 Z4
G31 X50 Z-30 F2 #1=1.3 #2=0.4 #3=0 #4=0 #5=2
M30
%
=== truth
rapid 33 0 4
rapid 25 0 4
thread 25 0 -28
thread 27 0 -30
rapid 33 0 -30
rapid 33 0 4
rapid 24.6 0 4
thread 24.6 0 -28
thread 26.6 0 -30
rapid 33 0 -30
rapid 33 0 4
rapid 24.2 0 4
thread 24.2 0 -28
thread 26.2 0 -30
rapid 33 0 -30
rapid 33 0 4
rapid 24.1 0 4
thread 24.1 0 -28
thread 26.1 0 -30
rapid 33 0 -30
rapid 33 0 4
rapid 23.9 0 4
thread 23.9 0 -28
thread 25.9 0 -30
rapid 33 0 -30
rapid 33 0 4
rapid 23.8 0 4
thread 23.8 0 -28
thread 25.8 0 -30
rapid 33 0 -30
rapid 33 0 4
rapid 23.75 0 4
thread 23.75 0 -28
thread 25.75 0 -30
rapid 33 0 -30
rapid 33 0 4
rapid 23.7 0 4
thread 23.7 0 -28
thread 25.7 0 -30
rapid 33 0 -30
rapid 33 0 4
rapid 23.7 0 4
thread 23.7 0 -28
thread 25.7 0 -30
rapid 33 0 -30
rapid 33 0 4
=== expect
file 0 main.nc
2: event spindle rpm=500 direction="cw"
3: rapid from 0 0 0 to 33 0 4 t0.132
file 1 %1
1/28 N3105 depth 1: rapid to 25 0 4 t0.032
1/29 depth 1: thread to 25 0 -28 F1000 t1.92
1/30 depth 1: thread to 27 0 -30 F1414.2136 t0.12
1/31 depth 1: rapid to 33 0 -30 t0.024
1/32 depth 1: rapid to 33 0 4 t0.136
1/28 N3105 depth 1: rapid to 24.6 0 4 t0.0336
1/29 depth 1: thread to 24.6 0 -28 F1000 t1.92
1/30 depth 1: thread to 26.6 0 -30 F1414.2136 t0.12
1/31 depth 1: rapid to 33 0 -30 t0.0256
1/32 depth 1: rapid to 33 0 4 t0.136
1/28 N3105 depth 1: rapid to 24.2 0 4 t0.0352
1/29 depth 1: thread to 24.2 0 -28 F1000 t1.92
1/30 depth 1: thread to 26.2 0 -30 F1414.2136 t0.12
1/31 depth 1: rapid to 33 0 -30 t0.0272
1/32 depth 1: rapid to 33 0 4 t0.136
1/28 N3105 depth 1: rapid to 24.1 0 4 t0.0356
1/29 depth 1: thread to 24.1 0 -28 F1000 t1.92
1/30 depth 1: thread to 26.1 0 -30 F1414.2136 t0.12
1/31 depth 1: rapid to 33 0 -30 t0.0276
1/32 depth 1: rapid to 33 0 4 t0.136
1/28 N3105 depth 1: rapid to 23.9 0 4 t0.0364
1/29 depth 1: thread to 23.9 0 -28 F1000 t1.92
1/30 depth 1: thread to 25.9 0 -30 F1414.2136 t0.12
1/31 depth 1: rapid to 33 0 -30 t0.0284
1/32 depth 1: rapid to 33 0 4 t0.136
1/28 N3105 depth 1: rapid to 23.8 0 4 t0.0368
1/29 depth 1: thread to 23.8 0 -28 F1000 t1.92
1/30 depth 1: thread to 25.8 0 -30 F1414.2136 t0.12
1/31 depth 1: rapid to 33 0 -30 t0.0288
1/32 depth 1: rapid to 33 0 4 t0.136
1/28 N3105 depth 1: rapid to 23.75 0 4 t0.037
1/29 depth 1: thread to 23.75 0 -28 F1000 t1.92
1/30 depth 1: thread to 25.75 0 -30 F1414.2136 t0.12
1/31 depth 1: rapid to 33 0 -30 t0.029
1/32 depth 1: rapid to 33 0 4 t0.136
1/28 N3105 depth 1: rapid to 23.7 0 4 t0.0372
1/29 depth 1: thread to 23.7 0 -28 F1000 t1.92
1/30 depth 1: thread to 25.7 0 -30 F1414.2136 t0.12
1/31 depth 1: rapid to 33 0 -30 t0.0292
1/32 depth 1: rapid to 33 0 4 t0.136
1/39 depth 1: rapid to 23.7 0 4 t0.0372
1/40 depth 1: thread to 23.7 0 -28 F1000 t1.92
1/41 depth 1: thread to 25.7 0 -30 F1414.2136 t0.12
1/42 depth 1: rapid to 33 0 -30 t0.0292
1/43 depth 1: rapid to 33 0 4 t0.136
5: event end code="M30"
end of program: 67 blocks, 46 motions, 0 errors, 0 warnings
