=== about
Digest wl4, 8.4: the motions of the fixed cycles, run from the text of the shipped programs.
proves: wl4-10.2-G80 wl4-10.3.1-G81 wl4-10.3.2-G82 wl4-10.3.3-G83 wl4-10.3.4-G84 wl4-10.3.5-G85 wl4-10.3.6-G86 wl4-10.3.9-G89 wl4-4-names wl4-9.4.2-IF wl4-9.4.1-lbl wl4-9.4.1-jmp wl4-5.4-G4 wl4-5.5-G9 wl4-5.6-G63 wl4-7.4-M3 wl4-7.4-M4 wl4-7.4-M5 wl4-7.4-M99 wl4-9.1-loc
=== settings
control = wl4-mill
=== main
%DRILL
G54 M3 S500
G0 X0 Y0 Z50
G81 #2=1 #3=-17 #4=2 #5=5 F100
G90G0X100Y200
G80
G0 X0 Y0 Z50
G82 #2=1 #3=-17 #4=2 #5=5 F100
G90G0X100Y200
G80
G0 X0 Y0 Z50
G83 #2=1 #3=-17 #4=2 #5=5 F100
G90G0X100Y200
G80
G0 X0 Y0 Z50
G84 #2=1 #3=-17 #4=2 #5=5 F100
G90G0X100Y200
G80
G0 X0 Y0 Z50
G85 #2=1 #3=-17 #4=2 #5=5 F100
G90G0X100Y200
G80
G0 X0 Y0 Z50
G86 #2=1 #3=-17 #4=2 #5=5 F100
G90G0X100Y200
G80
G0 X0 Y0 Z50
G89 #2=1 #3=-17 #4=2 #5=5 F100
G90G0X100Y200
G80
G0 X0 Y0 Z50
M30
%
=== truth
rapid 0 0 50
rapid 100 200 50
rapid 100 200 1
feed 100 200 -17
rapid 100 200 1
rapid 0 0 50
rapid 100 200 50
rapid 100 200 1
feed 100 200 -17
rapid 100 200 1
rapid 0 0 50
rapid 100 200 50
rapid 100 200 1
feed 100 200 -4
rapid 100 200 1
rapid 100 200 -3
feed 100 200 -9
rapid 100 200 1
rapid 100 200 -8
feed 100 200 -14
rapid 100 200 1
rapid 100 200 -13
feed 100 200 -17
rapid 100 200 1
rapid 0 0 50
rapid 100 200 50
rapid 100 200 1
feed 100 200 -17
feed 100 200 1
rapid 0 0 50
rapid 100 200 50
rapid 100 200 1
feed 100 200 -17
feed 100 200 1
rapid 0 0 50
rapid 100 200 50
rapid 100 200 1
feed 100 200 -17
rapid 100 200 1
rapid 0 0 50
rapid 100 200 50
rapid 100 200 1
feed 100 200 -17
feed 100 200 1
rapid 0 0 50
=== expect
file 0 main.nc
2: event spindle rpm=500 direction="cw"
3: rapid from 0 0 0 to 0 0 50 t0.2
5: rapid to 100 200 50 t0.8
file 1 %81
1/2 depth 1: rapid to 100 200 1 t0.196
1/3 depth 1: feed to 100 200 -17 F100 t10.8
1/4 depth 1: rapid to 100 200 1 t0.072
7: rapid to 0 0 50 t0.8
9: rapid to 100 200 50 t0.8
file 2 %82
2/2 depth 1: rapid to 100 200 1 t0.196
2/3 depth 1: feed to 100 200 -17 F100 t10.8
2/4 depth 1: event dwell seconds=2
2/5 depth 1: rapid to 100 200 1 t0.072
11: rapid to 0 0 50 t0.8
13: rapid to 100 200 50 t0.8
file 3 %83
3/4 depth 1: rapid to 100 200 1 t0.196
3/5 depth 1: feed to 100 200 -4 F100 t3
3/6 depth 1: rapid to 100 200 1 t0.02
3/4 depth 1: rapid to 100 200 -3 t0.016
3/5 depth 1: feed to 100 200 -9 F100 t3.6
3/6 depth 1: rapid to 100 200 1 t0.04
3/4 depth 1: rapid to 100 200 -8 t0.036
3/5 depth 1: feed to 100 200 -14 F100 t3.6
3/6 depth 1: rapid to 100 200 1 t0.06
3/4 depth 1: rapid to 100 200 -13 t0.056
3/5 depth 1: feed to 100 200 -17 F100 t2.4
3/6 depth 1: rapid to 100 200 1 t0.072
15: rapid to 0 0 50 t0.8
17: rapid to 100 200 50 t0.8
file 4 %84
4/2 depth 1: rapid to 100 200 1 t0.196
4/3 depth 1: feed to 100 200 -17 F100 t10.8
4/4 depth 1: event spindle rpm=500 direction="ccw"
4/5 depth 1: feed to 100 200 1 F100 t10.8
4/6 depth 1: event spindle rpm=500 direction="cw"
19: rapid to 0 0 50 t0.8
21: rapid to 100 200 50 t0.8
file 5 %85
5/2 depth 1: rapid to 100 200 1 t0.196
5/3 depth 1: feed to 100 200 -17 F100 t10.8
5/4 depth 1: feed to 100 200 1 F100 t10.8
23: rapid to 0 0 50 t0.8
25: rapid to 100 200 50 t0.8
file 6 %86
6/2 depth 1: rapid to 100 200 1 t0.196
6/3 depth 1: feed to 100 200 -17 F100 t10.8
6/4 depth 1: event spindle rpm=0 direction="stop"
6/5 depth 1: rapid to 100 200 1 t0.072
6/6 depth 1: event spindle rpm=500 direction="cw"
27: rapid to 0 0 50 t0.8
29: rapid to 100 200 50 t0.8
file 7 %89
7/2 depth 1: rapid to 100 200 1 t0.196
7/3 depth 1: feed to 100 200 -17 F100 t10.8
7/4 depth 1: event dwell seconds=2
7/5 depth 1: feed to 100 200 1 F100 t10.8
31: rapid to 0 0 50 t0.8
32: event end code="M30"
end of program: 84 blocks, 45 motions, 0 errors, 0 warnings
