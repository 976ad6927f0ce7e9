=== about
The table of operations of the drilling cycles, with return to the initial point and to R: motions and what the spindle does, in order.
proves: nct-18-ops nct-18-G98 nct-18-G99 nct-18.1.1-G73 nct-18.1.2-G74 nct-18.1.3-G76 nct-18.1.5-G81 nct-18.1.6-G82 nct-18.1.7-G83 nct-18.1.8-G84
nct-18.1.9-G84.2 nct-18.1.9-G84.3 nct-18.1.11-G85 nct-18.1.12-G86 nct-18.1.14-G88 nct-18.1.15-G89
=== main
G0 Z20 S100 M3
G98 G73 X10 Z-5 R2 Q4 E1 F100
G80
G99 G73 X20 Z-5 R2 Q4 E1 F100
G80
G0 Z20
M4
G98 G74 X30 Z-5 R2 P1 F100
G80 M3
M4
G99 G74 X40 Z-5 R2 P1 F100
G80 M3
G0 Z20
G98 G76 X50 Z-5 R2 I-1 P1 F100
G80
G99 G76 X60 Z-5 R2 I-1 P1 F100
G80
G0 Z20
G98 G81 X70 Z-5 R2 F100
G80
G99 G81 X80 Z-5 R2 F100
G80
G0 Z20
G98 G82 X90 Z-5 R2 P1 F100
G80
G99 G82 X100 Z-5 R2 P1 F100
G80
G0 Z20
G98 G83 X110 Z-5 R2 Q4 E1 F100
G80
G99 G83 X120 Z-5 R2 Q4 E1 F100
G80
G0 Z20
G98 G84 X130 Z-5 R2 P1 F100
G80
G99 G84 X140 Z-5 R2 P1 F100
G80
G0 Z20
G98 G85 X150 Z-5 R2 F100
G80
G99 G85 X160 Z-5 R2 F100
G80
G0 Z20
G98 G86 X170 Z-5 R2 F100
G80
G99 G86 X180 Z-5 R2 F100
G80
G0 Z20
G98 G88 X190 Z-5 R2 P1 F100
G80
G99 G88 X200 Z-5 R2 P1 F100
G80
G0 Z20
G98 G89 X210 Z-5 R2 P1 F100
G80
G99 G89 X220 Z-5 R2 P1 F100
G80
G0 Z20
G98 G84.2 X230 Z-5 R2 P1 F100
G80 M3
G99 G84.2 X240 Z-5 R2 P1 F100
G80 M3
G0 Z20
G98 G84.3 X250 Z-5 R2 P1 F100
G80 M3
G99 G84.3 X260 Z-5 R2 P1 F100
G80 M3
G0 Z20
M30
=== truth
rapid 0 0 20
rapid 10 0 20
rapid 10 0 2
feed 10 0 -2
rapid 10 0 -1
feed 10 0 -5
rapid 10 0 20
rapid 20 0 20
rapid 20 0 2
feed 20 0 -2
rapid 20 0 -1
feed 20 0 -5
rapid 20 0 2
rapid 20 0 20
rapid 30 0 20
rapid 30 0 2
thread 30 0 -5
thread 30 0 2
rapid 30 0 20
rapid 40 0 20
rapid 40 0 2
thread 40 0 -5
thread 40 0 2
rapid 40 0 20
rapid 50 0 20
rapid 50 0 2
feed 50 0 -5
rapid 49 0 -5
rapid 49 0 20
rapid 50 0 20
rapid 60 0 20
rapid 60 0 2
feed 60 0 -5
rapid 59 0 -5
rapid 59 0 2
rapid 60 0 2
rapid 60 0 20
rapid 70 0 20
rapid 70 0 2
feed 70 0 -5
rapid 70 0 20
rapid 80 0 20
rapid 80 0 2
feed 80 0 -5
rapid 80 0 2
rapid 80 0 20
rapid 90 0 20
rapid 90 0 2
feed 90 0 -5
rapid 90 0 20
rapid 100 0 20
rapid 100 0 2
feed 100 0 -5
rapid 100 0 2
rapid 100 0 20
rapid 110 0 20
rapid 110 0 2
feed 110 0 -2
rapid 110 0 2
rapid 110 0 -1
feed 110 0 -5
rapid 110 0 20
rapid 120 0 20
rapid 120 0 2
feed 120 0 -2
rapid 120 0 2
rapid 120 0 -1
feed 120 0 -5
rapid 120 0 2
rapid 120 0 20
rapid 130 0 20
rapid 130 0 2
thread 130 0 -5
thread 130 0 2
rapid 130 0 20
rapid 140 0 20
rapid 140 0 2
thread 140 0 -5
thread 140 0 2
rapid 140 0 20
rapid 150 0 20
rapid 150 0 2
feed 150 0 -5
feed 150 0 2
rapid 150 0 20
rapid 160 0 20
rapid 160 0 2
feed 160 0 -5
feed 160 0 2
rapid 160 0 20
rapid 170 0 20
rapid 170 0 2
feed 170 0 -5
rapid 170 0 20
rapid 180 0 20
rapid 180 0 2
feed 180 0 -5
rapid 180 0 2
rapid 180 0 20
rapid 190 0 20
rapid 190 0 2
feed 190 0 -5
rapid 190 0 20
rapid 200 0 20
rapid 200 0 2
feed 200 0 -5
rapid 200 0 2
rapid 200 0 20
rapid 210 0 20
rapid 210 0 2
feed 210 0 -5
feed 210 0 2
rapid 210 0 20
rapid 220 0 20
rapid 220 0 2
feed 220 0 -5
feed 220 0 2
rapid 220 0 20
rapid 230 0 20
rapid 230 0 2
thread 230 0 -5
thread 230 0 2
rapid 230 0 20
rapid 240 0 20
rapid 240 0 2
thread 240 0 -5
thread 240 0 2
rapid 240 0 20
rapid 250 0 20
rapid 250 0 2
thread 250 0 -5
thread 250 0 2
rapid 250 0 20
rapid 260 0 20
rapid 260 0 2
thread 260 0 -5
thread 260 0 2
rapid 260 0 20
=== says
rapid to 10 0 20 
rapid to 10 0 2 
feed to 10 0 -2 
rapid to 10 0 -1 
feed to 10 0 -5 
rapid to 10 0 20 
rapid to 20 0 20 
rapid to 20 0 2 
feed to 20 0 -2 
rapid to 20 0 -1 
feed to 20 0 -5 
rapid to 20 0 2 
rapid to 30 0 20 
rapid to 30 0 2 
thread to 30 0 -5 
dwell seconds=1
direction="cw"
thread to 30 0 2 
direction="ccw"
rapid to 30 0 20 
rapid to 40 0 20 
rapid to 40 0 2 
thread to 40 0 -5 
dwell seconds=1
direction="cw"
thread to 40 0 2 
direction="ccw"
rapid to 50 0 20 
rapid to 50 0 2 
feed to 50 0 -5 
dwell seconds=1
direction="oriented"
rapid to 49 0 -5 
rapid to 49 0 20 
rapid to 50 0 20 
direction="cw"
rapid to 60 0 20 
rapid to 60 0 2 
feed to 60 0 -5 
dwell seconds=1
direction="oriented"
rapid to 59 0 -5 
rapid to 59 0 2 
rapid to 60 0 2 
direction="cw"
rapid to 70 0 20 
rapid to 70 0 2 
feed to 70 0 -5 
rapid to 70 0 20 
rapid to 80 0 20 
rapid to 80 0 2 
feed to 80 0 -5 
rapid to 80 0 2 
rapid to 90 0 20 
rapid to 90 0 2 
feed to 90 0 -5 
dwell seconds=1
rapid to 90 0 20 
rapid to 100 0 20 
rapid to 100 0 2 
feed to 100 0 -5 
dwell seconds=1
rapid to 100 0 2 
rapid to 110 0 20 
rapid to 110 0 2 
feed to 110 0 -2 
rapid to 110 0 2 
rapid to 110 0 -1 
feed to 110 0 -5 
rapid to 110 0 20 
rapid to 120 0 20 
rapid to 120 0 2 
feed to 120 0 -2 
rapid to 120 0 2 
rapid to 120 0 -1 
feed to 120 0 -5 
rapid to 120 0 2 
rapid to 130 0 20 
rapid to 130 0 2 
thread to 130 0 -5 
dwell seconds=1
direction="ccw"
thread to 130 0 2 
direction="cw"
rapid to 130 0 20 
rapid to 140 0 20 
rapid to 140 0 2 
thread to 140 0 -5 
dwell seconds=1
direction="ccw"
thread to 140 0 2 
direction="cw"
rapid to 150 0 20 
rapid to 150 0 2 
feed to 150 0 -5 
feed to 150 0 2 
rapid to 150 0 20 
rapid to 160 0 20 
rapid to 160 0 2 
feed to 160 0 -5 
feed to 160 0 2 
rapid to 170 0 20 
rapid to 170 0 2 
feed to 170 0 -5 
direction="stop"
rapid to 170 0 20 
direction="cw"
rapid to 180 0 20 
rapid to 180 0 2 
feed to 180 0 -5 
direction="stop"
rapid to 180 0 2 
direction="cw"
rapid to 190 0 20 
rapid to 190 0 2 
feed to 190 0 -5 
dwell seconds=1
direction="stop"
stop code="M0"
rapid to 190 0 20 
direction="cw"
rapid to 200 0 20 
rapid to 200 0 2 
feed to 200 0 -5 
dwell seconds=1
direction="stop"
stop code="M0"
rapid to 200 0 2 
direction="cw"
rapid to 210 0 20 
rapid to 210 0 2 
feed to 210 0 -5 
dwell seconds=1
feed to 210 0 2 
rapid to 210 0 20 
rapid to 220 0 20 
rapid to 220 0 2 
feed to 220 0 -5 
dwell seconds=1
feed to 220 0 2 
rapid to 230 0 20 
rapid to 230 0 2 
direction="position loop"
thread to 230 0 -5 
dwell seconds=1
thread to 230 0 2 
rapid to 230 0 20 
rapid to 240 0 20 
rapid to 240 0 2 
direction="position loop"
thread to 240 0 -5 
dwell seconds=1
thread to 240 0 2 
rapid to 250 0 20 
rapid to 250 0 2 
direction="position loop"
thread to 250 0 -5 
dwell seconds=1
thread to 250 0 2 
rapid to 250 0 20 
rapid to 260 0 20 
rapid to 260 0 2 
direction="position loop"
thread to 260 0 -5 
dwell seconds=1
thread to 260 0 2 
=== expect
file 0 main.nc
1: event spindle rpm=100 direction="cw"
1: rapid from 0 0 0 to 0 0 20 t0.08
2: rapid to 10 0 20 t0.04
2: rapid to 10 0 2 t0.072
2: feed to 10 0 -2 F100 t2.4
2: rapid to 10 0 -1 t0.004
2: feed to 10 0 -5 F100 t2.4
2: rapid to 10 0 20 t0.1
4: rapid to 20 0 20 t0.04
4: rapid to 20 0 2 t0.072
4: feed to 20 0 -2 F100 t2.4
4: rapid to 20 0 -1 t0.004
4: feed to 20 0 -5 F100 t2.4
4: rapid to 20 0 2 t0.028
6: rapid to 20 0 20 t0.072
7: event spindle rpm=100 direction="ccw"
8: rapid to 30 0 20 t0.04
8: rapid to 30 0 2 t0.072
8: thread to 30 0 -5 F100 t4.2
8: event dwell seconds=1
8: event spindle rpm=100 direction="cw"
8: thread to 30 0 2 F100 t4.2
8: event spindle rpm=100 direction="ccw"
8: rapid to 30 0 20 t0.072
9: event spindle rpm=100 direction="cw"
10: event spindle rpm=100 direction="ccw"
11: rapid to 40 0 20 t0.04
11: rapid to 40 0 2 t0.072
11: thread to 40 0 -5 F100 t4.2
11: event dwell seconds=1
11: event spindle rpm=100 direction="cw"
11: thread to 40 0 2 F100 t4.2
11: event spindle rpm=100 direction="ccw"
12: event spindle rpm=100 direction="cw"
13: rapid to 40 0 20 t0.072
14: rapid to 50 0 20 t0.04
14: rapid to 50 0 2 t0.072
14: feed to 50 0 -5 F100 t4.2
14: event dwell seconds=1
14: event spindle rpm=0 direction="oriented"
14: rapid to 49 0 -5 t0.004
14: rapid to 49 0 20 t0.1
14: rapid to 50 0 20 t0.004
14: event spindle rpm=100 direction="cw"
16: rapid to 60 0 20 t0.04
16: rapid to 60 0 2 t0.072
16: feed to 60 0 -5 F100 t4.2
16: event dwell seconds=1
16: event spindle rpm=0 direction="oriented"
16: rapid to 59 0 -5 t0.004
16: rapid to 59 0 2 t0.028
16: rapid to 60 0 2 t0.004
16: event spindle rpm=100 direction="cw"
18: rapid to 60 0 20 t0.072
19: rapid to 70 0 20 t0.04
19: rapid to 70 0 2 t0.072
19: feed to 70 0 -5 F100 t4.2
19: rapid to 70 0 20 t0.1
21: rapid to 80 0 20 t0.04
21: rapid to 80 0 2 t0.072
21: feed to 80 0 -5 F100 t4.2
21: rapid to 80 0 2 t0.028
23: rapid to 80 0 20 t0.072
24: rapid to 90 0 20 t0.04
24: rapid to 90 0 2 t0.072
24: feed to 90 0 -5 F100 t4.2
24: event dwell seconds=1
24: rapid to 90 0 20 t0.1
26: rapid to 100 0 20 t0.04
26: rapid to 100 0 2 t0.072
26: feed to 100 0 -5 F100 t4.2
26: event dwell seconds=1
26: rapid to 100 0 2 t0.028
28: rapid to 100 0 20 t0.072
29: rapid to 110 0 20 t0.04
29: rapid to 110 0 2 t0.072
29: feed to 110 0 -2 F100 t2.4
29: rapid to 110 0 2 t0.016
29: rapid to 110 0 -1 t0.012
29: feed to 110 0 -5 F100 t2.4
29: rapid to 110 0 20 t0.1
31: rapid to 120 0 20 t0.04
31: rapid to 120 0 2 t0.072
31: feed to 120 0 -2 F100 t2.4
31: rapid to 120 0 2 t0.016
31: rapid to 120 0 -1 t0.012
31: feed to 120 0 -5 F100 t2.4
31: rapid to 120 0 2 t0.028
33: rapid to 120 0 20 t0.072
34: rapid to 130 0 20 t0.04
34: rapid to 130 0 2 t0.072
34: thread to 130 0 -5 F100 t4.2
34: event dwell seconds=1
34: event spindle rpm=100 direction="ccw"
34: thread to 130 0 2 F100 t4.2
34: event spindle rpm=100 direction="cw"
34: rapid to 130 0 20 t0.072
36: rapid to 140 0 20 t0.04
36: rapid to 140 0 2 t0.072
36: thread to 140 0 -5 F100 t4.2
36: event dwell seconds=1
36: event spindle rpm=100 direction="ccw"
36: thread to 140 0 2 F100 t4.2
36: event spindle rpm=100 direction="cw"
38: rapid to 140 0 20 t0.072
39: rapid to 150 0 20 t0.04
39: rapid to 150 0 2 t0.072
39: feed to 150 0 -5 F100 t4.2
39: feed to 150 0 2 F100 t4.2
39: rapid to 150 0 20 t0.072
41: rapid to 160 0 20 t0.04
41: rapid to 160 0 2 t0.072
41: feed to 160 0 -5 F100 t4.2
41: feed to 160 0 2 F100 t4.2
43: rapid to 160 0 20 t0.072
44: rapid to 170 0 20 t0.04
44: rapid to 170 0 2 t0.072
44: feed to 170 0 -5 F100 t4.2
44: event spindle rpm=0 direction="stop"
44: rapid to 170 0 20 t0.1
44: event spindle rpm=100 direction="cw"
46: rapid to 180 0 20 t0.04
46: rapid to 180 0 2 t0.072
46: feed to 180 0 -5 F100 t4.2
46: event spindle rpm=0 direction="stop"
46: rapid to 180 0 2 t0.028
46: event spindle rpm=100 direction="cw"
48: rapid to 180 0 20 t0.072
49: rapid to 190 0 20 t0.04
49: rapid to 190 0 2 t0.072
49: feed to 190 0 -5 F100 t4.2
49: event dwell seconds=1
49: event spindle rpm=0 direction="stop"
49: event stop code="M0" reason="manual intervention in the cycle"
49: rapid to 190 0 20 t0.1
49: event spindle rpm=100 direction="cw"
51: rapid to 200 0 20 t0.04
51: rapid to 200 0 2 t0.072
51: feed to 200 0 -5 F100 t4.2
51: event dwell seconds=1
51: event spindle rpm=0 direction="stop"
51: event stop code="M0" reason="manual intervention in the cycle"
51: rapid to 200 0 2 t0.028
51: event spindle rpm=100 direction="cw"
53: rapid to 200 0 20 t0.072
54: rapid to 210 0 20 t0.04
54: rapid to 210 0 2 t0.072
54: feed to 210 0 -5 F100 t4.2
54: event dwell seconds=1
54: feed to 210 0 2 F100 t4.2
54: rapid to 210 0 20 t0.072
56: rapid to 220 0 20 t0.04
56: rapid to 220 0 2 t0.072
56: feed to 220 0 -5 F100 t4.2
56: event dwell seconds=1
56: feed to 220 0 2 F100 t4.2
58: rapid to 220 0 20 t0.072
59: rapid to 230 0 20 t0.04
59: rapid to 230 0 2 t0.072
59: event spindle rpm=0 direction="position loop"
59: thread to 230 0 -5 F100 t4.2
59: event dwell seconds=1
59: thread to 230 0 2 F100 t4.2
59: rapid to 230 0 20 t0.072
60: event spindle rpm=100 direction="cw"
61: rapid to 240 0 20 t0.04
61: rapid to 240 0 2 t0.072
61: event spindle rpm=0 direction="position loop"
61: thread to 240 0 -5 F100 t4.2
61: event dwell seconds=1
61: thread to 240 0 2 F100 t4.2
62: event spindle rpm=100 direction="cw"
63: rapid to 240 0 20 t0.072
64: rapid to 250 0 20 t0.04
64: rapid to 250 0 2 t0.072
64: event spindle rpm=0 direction="position loop"
64: thread to 250 0 -5 F100 t4.2
64: event dwell seconds=1
64: thread to 250 0 2 F100 t4.2
64: rapid to 250 0 20 t0.072
65: event spindle rpm=100 direction="cw"
66: rapid to 260 0 20 t0.04
66: rapid to 260 0 2 t0.072
66: event spindle rpm=0 direction="position loop"
66: thread to 260 0 -5 F100 t4.2
66: event dwell seconds=1
66: thread to 260 0 2 F100 t4.2
67: event spindle rpm=100 direction="cw"
68: rapid to 260 0 20 t0.072
69: event end code="M30"
end of program: 69 blocks, 138 motions, 0 errors, 0 warnings
