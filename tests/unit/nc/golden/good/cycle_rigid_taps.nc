=== about
Rigid taps. N1503.TSC: the spindle is oriented before the tap instead of being put into the position loop. Left-hand with chip breaking: out by E, or
by N1504. N1503.EOE: the way out at N1506 percent, or at I.
proves: nct-18.1.9-TSC nct-18.1.9-EOE nct-18.1.10-G84.3Q
=== settings
N1503.TSC = 1
N1503.EOE = 1
N1504 = 0.5
N1506 = 200
=== main
G0 Z2 S100 M3
G99 G84.3 X10 Z-10 R2 Q5 E2 F100
G80
G84.3 X20 Z-10 R2 Q5
G84.2 X30 I150
M30
=== truth
0 0 2
10 0 2
thread 10 0 -3 F 100
thread 10 0 -1 F 100
thread 10 0 -8 F 100
thread 10 0 -6 F 100
thread 10 0 -10 F 100
thread 10 0 2 F 200
20 0 2
thread 20 0 -3 F 100
thread 20 0 -2.5 F 100
thread 20 0 -8 F 100
thread 20 0 -7.5 F 100
thread 20 0 -10 F 100
thread 20 0 2 F 200
30 0 2
thread 30 0 -3 F 100
thread 30 0 -2.5 F 100
thread 30 0 -8 F 100
thread 30 0 -7.5 F 100
thread 30 0 -10 F 100
thread 30 0 2 F 150
=== expect
file 0 main.nc
1: event spindle rpm=100 direction="cw"
1: rapid from 0 0 0 to 0 0 2 t0.008
2: rapid to 10 0 2 t0.04
2: event spindle rpm=0 direction="oriented"
2: thread to 10 0 -3 F100 t3
2: thread to 10 0 -1 F100 t1.2
2: thread to 10 0 -8 F100 t4.2
2: thread to 10 0 -6 F100 t1.2
2: thread to 10 0 -10 F100 t2.4
2: thread to 10 0 2 F200 t3.6
4: rapid to 20 0 2 t0.04
4: event spindle rpm=0 direction="oriented"
4: thread to 20 0 -3 F100 t3
4: thread to 20 0 -2.5 F100 t0.3
4: thread to 20 0 -8 F100 t3.3
4: thread to 20 0 -7.5 F100 t0.3
4: thread to 20 0 -10 F100 t1.5
4: thread to 20 0 2 F200 t3.6
5: rapid to 30 0 2 t0.04
5: event spindle rpm=0 direction="oriented"
5: thread to 30 0 -3 F100 t3
5: thread to 30 0 -2.5 F100 t0.3
5: thread to 30 0 -8 F100 t3.3
5: thread to 30 0 -7.5 F100 t0.3
5: thread to 30 0 -10 F100 t1.5
5: thread to 30 0 2 F150 t4.8
6: event end code="M30"
end of program: 6 blocks, 22 motions, 0 errors, 0 warnings
