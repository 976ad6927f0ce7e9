=== about
Digest wl4, 8.4: G87 and G88 orient the spindle and leave the bore 0.5 mm aside; the gear is read and put back.
proves: wl4-10.3.7-G87 wl4-10.3.8-G88 wl4-7.4-M19 wl4-7.4-M40 wl4-9.2-117 wl4-7.4-M2
=== settings
control = wl4-mill
=== main
%BORE
G54 M3 S500 M41
G0 X0 Y0 Z50
G87 #2=1 #3=-17 #4=2 F100
G90G0X100Y200
G80
G0 X0 Y0 Z50
G88 #2=1 #3=-17 #4=2 F100
G90G0X100Y200
G80
G0 X0 Y0 Z50
M2
%
=== truth
rapid 0 0 50
rapid 100 200 50
rapid 100 200 1
feed 100 200 -17
rapid 100.5 200 -17
rapid 100.5 200 1
rapid 0 0 50
rapid 100 200 50
rapid 100 200 1
feed 100 200 -17
rapid 100.5 200 -17
rapid 100.5 200 1
rapid 0 0 50
=== expect
file 0 main.nc
2: event spindle rpm=500 direction="cw"
2: event function code="M41"
3: rapid from 0 0 0 to 0 0 50 t0.2
5: rapid to 100 200 50 t0.8
file 1 %87
1/3 depth 1: rapid to 100 200 1 t0.196
1/4 depth 1: feed to 100 200 -17 F100 t10.8
1/5 depth 1: event function code="M40"
1/5 depth 1: event spindle rpm=0 direction="stop"
1/5 depth 1: event spindle rpm=0 direction="oriented"
1/6 depth 1: rapid to 100.5 200 -17 t0.002
1/7 depth 1: rapid to 100.5 200 1 t0.072
1/8 depth 1: event function code="M41"
1/8 depth 1: event spindle rpm=500 direction="cw"
7: rapid to 0 0 50 t0.8
9: rapid to 100 200 50 t0.8
file 2 %88
2/3 depth 1: rapid to 100 200 1 t0.196
2/4 depth 1: feed to 100 200 -17 F100 t10.8
2/5 depth 1: event dwell seconds=2
2/6 depth 1: event function code="M40"
2/6 depth 1: event spindle rpm=0 direction="stop"
2/6 depth 1: event spindle rpm=0 direction="oriented"
2/7 depth 1: rapid to 100.5 200 -17 t0.002
2/8 depth 1: rapid to 100.5 200 1 t0.072
2/9 depth 1: event function code="M41"
2/9 depth 1: event spindle rpm=500 direction="cw"
11: rapid to 0 0 50 t0.8
12: event end code="M2"
end of program: 28 blocks, 13 motions, 0 errors, 0 warnings
