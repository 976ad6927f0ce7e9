=== about
Digest wl4, 9.8: the tests of the open cycles G77 and G78.
proves: wl4-11.10-G77 wl4-11.12-G78 wl4-9.2-139
=== settings
control = wl4-lathe
=== main
%ROUGH
G54 G95
G0 X60 Z2
G77 X40 Z-50 F0.3 #1=8 #2=5 #3=0.1
G0 X40 Z2
G77 X60 Z-50 F0.3 #1=8 #2=5 #3=0.1
G0 X62 Z1
G78 X20 Z-20 F0.3 #1=8 #2=6 #3=0.1
M30
%
=== truth
rapid 30 0 2
rapid 26 0 2
feed 26 0 -48
rapid 30 0 -40
rapid 30 0 2
rapid 22 0 2
feed 22 0 -46
rapid 26 0 -38
rapid 26 0 2
rapid 20 0 2
feed 20 0 -45
feed 30 0 -50
rapid 30 0 2
rapid 20 0 2
rapid 24 0 2
feed 24 0 -48
rapid 20 0 -40
rapid 20 0 2
rapid 28 0 2
feed 28 0 -46
rapid 24 0 -38
rapid 24 0 2
rapid 30 0 2
feed 30 0 -45
feed 20 0 -50
rapid 20 0 2
rapid 31 0 1
rapid 31 0 -7
feed 11.1428 0 -7
rapid 15.1428 0 1
rapid 31 0 1
rapid 31 0 -15
feed 12.2857 0 -15
rapid 16.2857 0 -7
rapid 31 0 -7
rapid 31 0 -20
feed 13 0 -20
feed 10 0 1
rapid 31 0 1
=== expect
file 0 main.nc
3: rapid from 0 0 0 to 30 0 2 t0.12
file 1 %1
1/159 depth 1: rapid to 26 0 2 t0.016
%1:161:1: warning[wl4-spindle-off]: feed per revolution while the spindle stands: timed at 1000 1/min
    N07707 #27=(#27+#21) G1 W#25=(#24-#27*#28)
    ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
    note: called from main.nc:4
1/161 N7707 depth 1: feed to 26 0 -48 F300 t10
1/162 depth 1: rapid to 30 0 -40 t0.032
1/163 depth 1: rapid to 30 0 2 t0.168
1/160 N7706 depth 1: rapid to 22 0 2 t0.032
1/161 N7707 depth 1: feed to 22 0 -46 F300 t9.6
1/162 depth 1: rapid to 26 0 -38 t0.032
1/163 depth 1: rapid to 26 0 2 t0.16
1/165 depth 1: rapid to 20 0 2 t0.024
1/166 depth 1: feed to 20 0 -45 F100 t28.2
1/167 depth 1: feed to 30 0 -50 F100 t6.7082
1/168 depth 1: rapid to 30 0 2 t0.208
5: rapid to 20 0 2 t0.04
1/159 depth 1: rapid to 24 0 2 t0.016
1/161 N7707 depth 1: feed to 24 0 -48 F300 t10
1/162 depth 1: rapid to 20 0 -40 t0.032
1/163 depth 1: rapid to 20 0 2 t0.168
1/160 N7706 depth 1: rapid to 28 0 2 t0.032
1/161 N7707 depth 1: feed to 28 0 -46 F300 t9.6
1/162 depth 1: rapid to 24 0 -38 t0.032
1/163 depth 1: rapid to 24 0 2 t0.16
1/165 depth 1: rapid to 30 0 2 t0.024
1/166 depth 1: feed to 30 0 -45 F100 t28.2
1/167 depth 1: feed to 20 0 -50 F100 t6.7082
1/168 depth 1: rapid to 20 0 2 t0.208
7: rapid to 31 0 1 t0.044
1/182 depth 1: rapid to 31 0 -7 t0.032
1/184 N7807 depth 1: feed to 11.1429 0 -7 F300 t3.9714
1/185 depth 1: rapid to 15.1429 0 1 t0.032
1/186 depth 1: rapid to 31 0 1 t0.0634
1/183 N7806 depth 1: rapid to 31 0 -15 t0.064
1/184 N7807 depth 1: feed to 12.2857 0 -15 F300 t3.7429
1/185 depth 1: rapid to 16.2857 0 -7 t0.032
1/186 depth 1: rapid to 31 0 -7 t0.0589
1/188 depth 1: rapid to 31 0 -20 t0.052
1/189 depth 1: feed to 13 0 -20 F100 t10.8
1/190 depth 1: feed to 10 0 1 F100 t12.7279
1/191 depth 1: rapid to 31 0 1 t0.084
9: event end code="M30"
end of program: 62 blocks, 39 motions, 0 errors, 1 warnings
