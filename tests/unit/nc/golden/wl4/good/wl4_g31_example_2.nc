=== about
Digest wl4, 9.4, worked example 2: taper and infeed angle.
proves: wl4-11.1-G31
=== settings
control = wl4-lathe
=== main
%THREAD
G54 G97 S500 M3
G0 X66 Z6
G31 X50 Z-40 F3 #1=1 #2=0.5 #3=4 #4=30 #5=3
M30
%
=== truth
rapid 33 0 6
rapid 25.1959 0 1.4943
thread 26.8696 0 -37
thread 29.8696 0 -40
rapid 33 0 -40
rapid 33 0 6
rapid 24.7081 0 1.2127
thread 26.3696 0 -37
thread 29.3696 0 -40
rapid 33 0 -40
rapid 33 0 6
rapid 24.4642 0 1.0719
thread 26.1196 0 -37
thread 29.1196 0 -40
rapid 33 0 -40
rapid 33 0 6
rapid 24.3423 0 1.0015
thread 25.9946 0 -37
thread 28.9946 0 -40
rapid 33 0 -40
rapid 33 0 6
rapid 24.2813 0 0.9663
thread 25.9321 0 -37
thread 28.9321 0 -40
rapid 33 0 -40
rapid 33 0 6
rapid 24.2204 0 0.9311
thread 25.8696 0 -37
thread 28.8696 0 -40
rapid 33 0 -40
rapid 33 0 6
rapid 24.2204 0 0.9311
thread 25.8696 0 -37
thread 28.8696 0 -40
rapid 33 0 -40
rapid 33 0 6
=== expect
file 0 main.nc
2: event spindle rpm=500 direction="cw"
3: rapid from 0 0 0 to 33 0 6 t0.132
file 1 %1
1/28 N3105 depth 1: rapid to 25.1959 0 1.4943 t0.0312
1/29 depth 1: thread to 26.8696 0 -37 F1501.4171 t1.5398
1/30 depth 1: thread to 29.8696 0 -40 F2121.3203 t0.12 start 299.3161
1/31 depth 1: rapid to 33 0 -40 t0.0125
1/32 depth 1: rapid to 33 0 6 t0.184
1/28 N3105 depth 1: rapid to 24.7081 0 1.2127 t0.0332
1/29 depth 1: thread to 26.3696 0 -37 F1501.4171 t1.5285
1/30 depth 1: thread to 29.3696 0 -40 F2121.3203 t0.12 start 265.5233
1/31 depth 1: rapid to 33 0 -40 t0.0145
1/32 depth 1: rapid to 33 0 6 t0.184
1/28 N3105 depth 1: rapid to 24.4643 0 1.0719 t0.0341
1/29 depth 1: thread to 26.1196 0 -37 F1501.4171 t1.5229
1/30 depth 1: thread to 29.1196 0 -40 F2121.3203 t0.12 start 248.627
1/31 depth 1: rapid to 33 0 -40 t0.0155
1/32 depth 1: rapid to 33 0 6 t0.184
1/28 N3105 depth 1: rapid to 24.3423 0 1.0015 t0.0346
1/29 depth 1: thread to 25.9946 0 -37 F1501.4171 t1.5201
1/30 depth 1: thread to 28.9946 0 -40 F2121.3203 t0.12 start 240.1788
1/31 depth 1: rapid to 33 0 -40 t0.016
1/32 depth 1: rapid to 33 0 6 t0.184
1/28 N3105 depth 1: rapid to 24.2814 0 0.9663 t0.0349
1/29 depth 1: thread to 25.9321 0 -37 F1501.4171 t1.5187
1/30 depth 1: thread to 28.9321 0 -40 F2121.3203 t0.12 start 235.9547
1/31 depth 1: rapid to 33 0 -40 t0.0163
1/32 depth 1: rapid to 33 0 6 t0.184
1/28 N3105 depth 1: rapid to 24.2204 0 0.9311 t0.0351
1/29 depth 1: thread to 25.8696 0 -37 F1501.4171 t1.5172
1/30 depth 1: thread to 28.8696 0 -40 F2121.3203 t0.12 start 231.7306
1/31 depth 1: rapid to 33 0 -40 t0.0165
1/32 depth 1: rapid to 33 0 6 t0.184
1/39 depth 1: rapid to 24.2204 0 0.9311 t0.0351
1/40 depth 1: thread to 25.8696 0 -37 F1501.4171 t1.5172
1/41 depth 1: thread to 28.8696 0 -40 F2121.3203 t0.12 start 231.7306
1/42 depth 1: rapid to 33 0 -40 t0.0165
1/43 depth 1: rapid to 33 0 6 t0.184
5: event end code="M30"
end of program: 55 blocks, 36 motions, 0 errors, 0 warnings
