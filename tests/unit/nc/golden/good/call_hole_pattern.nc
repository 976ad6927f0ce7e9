=== about
Digest nct-5, section 12: the same five holes drilled, pecked and tapped.
proves: nct-23.3.1-G65
=== main
G54 G17 G0 X0 Y0 Z20
G65 P300 A81 Z-2 R2 F300 S500 M3
G65 P300 A83 Z-30 R2 Q6 E1 F100 S1000
G65 P300 A84.2 Z-30 R2 S1000 F1000
G0 Z25
M30
=== sub O0300
S#19 M#13
G#1 X0 Y0 Z#26 R#18 F#9 Q#17 E#8
X100
Y100
X0
X50 Y50
G80
M99
=== truth
rapid 0 0 20
rapid 0 0 2
feed 0 0 -2 F 300 S 500
rapid 0 0 20
rapid 100 0 20
rapid 100 0 2
feed 100 0 -2 F 300 S 500
rapid 100 0 20
rapid 100 100 20
rapid 100 100 2
feed 100 100 -2 F 300 S 500
rapid 100 100 20
rapid 0 100 20
rapid 0 100 2
feed 0 100 -2 F 300 S 500
rapid 0 100 20
rapid 50 50 20
rapid 50 50 2
feed 50 50 -2 F 300 S 500
rapid 50 50 20
rapid 0 0 20
rapid 0 0 2
feed 0 0 -4 F 100 S 1000
rapid 0 0 2
rapid 0 0 -3
feed 0 0 -10 F 100 S 1000
rapid 0 0 2
rapid 0 0 -9
feed 0 0 -16 F 100 S 1000
rapid 0 0 2
rapid 0 0 -15
feed 0 0 -22 F 100 S 1000
rapid 0 0 2
rapid 0 0 -21
feed 0 0 -28 F 100 S 1000
rapid 0 0 2
rapid 0 0 -27
feed 0 0 -30 F 100 S 1000
rapid 0 0 20
rapid 100 0 20
rapid 100 0 2
feed 100 0 -4 F 100 S 1000
rapid 100 0 2
rapid 100 0 -3
feed 100 0 -10 F 100 S 1000
rapid 100 0 2
rapid 100 0 -9
feed 100 0 -16 F 100 S 1000
rapid 100 0 2
rapid 100 0 -15
feed 100 0 -22 F 100 S 1000
rapid 100 0 2
rapid 100 0 -21
feed 100 0 -28 F 100 S 1000
rapid 100 0 2
rapid 100 0 -27
feed 100 0 -30 F 100 S 1000
rapid 100 0 20
rapid 100 100 20
rapid 100 100 2
feed 100 100 -4 F 100 S 1000
rapid 100 100 2
rapid 100 100 -3
feed 100 100 -10 F 100 S 1000
rapid 100 100 2
rapid 100 100 -9
feed 100 100 -16 F 100 S 1000
rapid 100 100 2
rapid 100 100 -15
feed 100 100 -22 F 100 S 1000
rapid 100 100 2
rapid 100 100 -21
feed 100 100 -28 F 100 S 1000
rapid 100 100 2
rapid 100 100 -27
feed 100 100 -30 F 100 S 1000
rapid 100 100 20
rapid 0 100 20
rapid 0 100 2
feed 0 100 -4 F 100 S 1000
rapid 0 100 2
rapid 0 100 -3
feed 0 100 -10 F 100 S 1000
rapid 0 100 2
rapid 0 100 -9
feed 0 100 -16 F 100 S 1000
rapid 0 100 2
rapid 0 100 -15
feed 0 100 -22 F 100 S 1000
rapid 0 100 2
rapid 0 100 -21
feed 0 100 -28 F 100 S 1000
rapid 0 100 2
rapid 0 100 -27
feed 0 100 -30 F 100 S 1000
rapid 0 100 20
rapid 50 50 20
rapid 50 50 2
feed 50 50 -4 F 100 S 1000
rapid 50 50 2
rapid 50 50 -3
feed 50 50 -10 F 100 S 1000
rapid 50 50 2
rapid 50 50 -9
feed 50 50 -16 F 100 S 1000
rapid 50 50 2
rapid 50 50 -15
feed 50 50 -22 F 100 S 1000
rapid 50 50 2
rapid 50 50 -21
feed 50 50 -28 F 100 S 1000
rapid 50 50 2
rapid 50 50 -27
feed 50 50 -30 F 100 S 1000
rapid 50 50 20
rapid 0 0 20
rapid 0 0 2
thread 0 0 -30 F 1000 S 1000
thread 0 0 2 F 1000 S -1000
rapid 0 0 20
rapid 100 0 20
rapid 100 0 2
thread 100 0 -30 F 1000 S 1000
thread 100 0 2 F 1000 S -1000
rapid 100 0 20
rapid 100 100 20
rapid 100 100 2
thread 100 100 -30 F 1000 S 1000
thread 100 100 2 F 1000 S -1000
rapid 100 100 20
rapid 0 100 20
rapid 0 100 2
thread 0 100 -30 F 1000 S 1000
thread 0 100 2 F 1000 S -1000
rapid 0 100 20
rapid 50 50 20
rapid 50 50 2
thread 50 50 -30 F 1000 S 1000
thread 50 50 2 F 1000 S -1000
rapid 50 50 20
rapid 50 50 25
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 20 t0.08
file 1 O0300
1/1 depth 1: event spindle rpm=500 direction="cw"
1/2 depth 1: rapid to 0 0 2 t0.072
1/2 depth 1: feed to 0 0 -2 F300 t0.8
1/2 depth 1: rapid to 0 0 20 t0.088
1/3 depth 1: rapid to 100 0 20 t0.4
1/3 depth 1: rapid to 100 0 2 t0.072
1/3 depth 1: feed to 100 0 -2 F300 t0.8
1/3 depth 1: rapid to 100 0 20 t0.088
1/4 depth 1: rapid to 100 100 20 t0.4
1/4 depth 1: rapid to 100 100 2 t0.072
1/4 depth 1: feed to 100 100 -2 F300 t0.8
1/4 depth 1: rapid to 100 100 20 t0.088
1/5 depth 1: rapid to 0 100 20 t0.4
1/5 depth 1: rapid to 0 100 2 t0.072
1/5 depth 1: feed to 0 100 -2 F300 t0.8
1/5 depth 1: rapid to 0 100 20 t0.088
1/6 depth 1: rapid to 50 50 20 t0.2
1/6 depth 1: rapid to 50 50 2 t0.072
1/6 depth 1: feed to 50 50 -2 F300 t0.8
1/6 depth 1: rapid to 50 50 20 t0.088
1/1 depth 1: event spindle rpm=1000 direction="cw"
1/2 depth 1: rapid to 0 0 20 t0.2
1/2 depth 1: rapid to 0 0 2 t0.072
1/2 depth 1: feed to 0 0 -4 F100 t3.6
1/2 depth 1: rapid to 0 0 2 t0.024
1/2 depth 1: rapid to 0 0 -3 t0.02
1/2 depth 1: feed to 0 0 -10 F100 t4.2
1/2 depth 1: rapid to 0 0 2 t0.048
1/2 depth 1: rapid to 0 0 -9 t0.044
1/2 depth 1: feed to 0 0 -16 F100 t4.2
1/2 depth 1: rapid to 0 0 2 t0.072
1/2 depth 1: rapid to 0 0 -15 t0.068
1/2 depth 1: feed to 0 0 -22 F100 t4.2
1/2 depth 1: rapid to 0 0 2 t0.096
1/2 depth 1: rapid to 0 0 -21 t0.092
1/2 depth 1: feed to 0 0 -28 F100 t4.2
1/2 depth 1: rapid to 0 0 2 t0.12
1/2 depth 1: rapid to 0 0 -27 t0.116
1/2 depth 1: feed to 0 0 -30 F100 t1.8
1/2 depth 1: rapid to 0 0 20 t0.2
1/3 depth 1: rapid to 100 0 20 t0.4
1/3 depth 1: rapid to 100 0 2 t0.072
1/3 depth 1: feed to 100 0 -4 F100 t3.6
1/3 depth 1: rapid to 100 0 2 t0.024
1/3 depth 1: rapid to 100 0 -3 t0.02
1/3 depth 1: feed to 100 0 -10 F100 t4.2
1/3 depth 1: rapid to 100 0 2 t0.048
1/3 depth 1: rapid to 100 0 -9 t0.044
1/3 depth 1: feed to 100 0 -16 F100 t4.2
1/3 depth 1: rapid to 100 0 2 t0.072
1/3 depth 1: rapid to 100 0 -15 t0.068
1/3 depth 1: feed to 100 0 -22 F100 t4.2
1/3 depth 1: rapid to 100 0 2 t0.096
1/3 depth 1: rapid to 100 0 -21 t0.092
1/3 depth 1: feed to 100 0 -28 F100 t4.2
1/3 depth 1: rapid to 100 0 2 t0.12
1/3 depth 1: rapid to 100 0 -27 t0.116
1/3 depth 1: feed to 100 0 -30 F100 t1.8
1/3 depth 1: rapid to 100 0 20 t0.2
1/4 depth 1: rapid to 100 100 20 t0.4
1/4 depth 1: rapid to 100 100 2 t0.072
1/4 depth 1: feed to 100 100 -4 F100 t3.6
1/4 depth 1: rapid to 100 100 2 t0.024
1/4 depth 1: rapid to 100 100 -3 t0.02
1/4 depth 1: feed to 100 100 -10 F100 t4.2
1/4 depth 1: rapid to 100 100 2 t0.048
1/4 depth 1: rapid to 100 100 -9 t0.044
1/4 depth 1: feed to 100 100 -16 F100 t4.2
1/4 depth 1: rapid to 100 100 2 t0.072
1/4 depth 1: rapid to 100 100 -15 t0.068
1/4 depth 1: feed to 100 100 -22 F100 t4.2
1/4 depth 1: rapid to 100 100 2 t0.096
1/4 depth 1: rapid to 100 100 -21 t0.092
1/4 depth 1: feed to 100 100 -28 F100 t4.2
1/4 depth 1: rapid to 100 100 2 t0.12
1/4 depth 1: rapid to 100 100 -27 t0.116
1/4 depth 1: feed to 100 100 -30 F100 t1.8
1/4 depth 1: rapid to 100 100 20 t0.2
1/5 depth 1: rapid to 0 100 20 t0.4
1/5 depth 1: rapid to 0 100 2 t0.072
1/5 depth 1: feed to 0 100 -4 F100 t3.6
1/5 depth 1: rapid to 0 100 2 t0.024
1/5 depth 1: rapid to 0 100 -3 t0.02
1/5 depth 1: feed to 0 100 -10 F100 t4.2
1/5 depth 1: rapid to 0 100 2 t0.048
1/5 depth 1: rapid to 0 100 -9 t0.044
1/5 depth 1: feed to 0 100 -16 F100 t4.2
1/5 depth 1: rapid to 0 100 2 t0.072
1/5 depth 1: rapid to 0 100 -15 t0.068
1/5 depth 1: feed to 0 100 -22 F100 t4.2
1/5 depth 1: rapid to 0 100 2 t0.096
1/5 depth 1: rapid to 0 100 -21 t0.092
1/5 depth 1: feed to 0 100 -28 F100 t4.2
1/5 depth 1: rapid to 0 100 2 t0.12
1/5 depth 1: rapid to 0 100 -27 t0.116
1/5 depth 1: feed to 0 100 -30 F100 t1.8
1/5 depth 1: rapid to 0 100 20 t0.2
1/6 depth 1: rapid to 50 50 20 t0.2
1/6 depth 1: rapid to 50 50 2 t0.072
1/6 depth 1: feed to 50 50 -4 F100 t3.6
1/6 depth 1: rapid to 50 50 2 t0.024
1/6 depth 1: rapid to 50 50 -3 t0.02
1/6 depth 1: feed to 50 50 -10 F100 t4.2
1/6 depth 1: rapid to 50 50 2 t0.048
1/6 depth 1: rapid to 50 50 -9 t0.044
1/6 depth 1: feed to 50 50 -16 F100 t4.2
1/6 depth 1: rapid to 50 50 2 t0.072
1/6 depth 1: rapid to 50 50 -15 t0.068
1/6 depth 1: feed to 50 50 -22 F100 t4.2
1/6 depth 1: rapid to 50 50 2 t0.096
1/6 depth 1: rapid to 50 50 -21 t0.092
1/6 depth 1: feed to 50 50 -28 F100 t4.2
1/6 depth 1: rapid to 50 50 2 t0.12
1/6 depth 1: rapid to 50 50 -27 t0.116
1/6 depth 1: feed to 50 50 -30 F100 t1.8
1/6 depth 1: rapid to 50 50 20 t0.2
1/2 depth 1: rapid to 0 0 20 t0.2
1/2 depth 1: rapid to 0 0 2 t0.072
1/2 depth 1: event spindle rpm=0 direction="position loop"
1/2 depth 1: thread to 0 0 -30 F1000 t1.92
1/2 depth 1: thread to 0 0 2 F1000 t1.92
1/2 depth 1: rapid to 0 0 20 t0.072
1/3 depth 1: rapid to 100 0 20 t0.4
1/3 depth 1: rapid to 100 0 2 t0.072
1/3 depth 1: event spindle rpm=0 direction="position loop"
1/3 depth 1: thread to 100 0 -30 F1000 t1.92
1/3 depth 1: thread to 100 0 2 F1000 t1.92
1/3 depth 1: rapid to 100 0 20 t0.072
1/4 depth 1: rapid to 100 100 20 t0.4
1/4 depth 1: rapid to 100 100 2 t0.072
1/4 depth 1: event spindle rpm=0 direction="position loop"
1/4 depth 1: thread to 100 100 -30 F1000 t1.92
1/4 depth 1: thread to 100 100 2 F1000 t1.92
1/4 depth 1: rapid to 100 100 20 t0.072
1/5 depth 1: rapid to 0 100 20 t0.4
1/5 depth 1: rapid to 0 100 2 t0.072
1/5 depth 1: event spindle rpm=0 direction="position loop"
1/5 depth 1: thread to 0 100 -30 F1000 t1.92
1/5 depth 1: thread to 0 100 2 F1000 t1.92
1/5 depth 1: rapid to 0 100 20 t0.072
1/6 depth 1: rapid to 50 50 20 t0.2
1/6 depth 1: rapid to 50 50 2 t0.072
1/6 depth 1: event spindle rpm=0 direction="position loop"
1/6 depth 1: thread to 50 50 -30 F1000 t1.92
1/6 depth 1: thread to 50 50 2 F1000 t1.92
1/6 depth 1: rapid to 50 50 20 t0.072
5: rapid to 50 50 25 t0.02
6: event end code="M30"
end of program: 30 blocks, 141 motions, 0 errors, 0 warnings
