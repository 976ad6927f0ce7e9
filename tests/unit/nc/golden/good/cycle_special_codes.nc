=== about
proves: nct-18-CSM
=== settings
N1503.CSM = 1
=== main
G17 G90 G0 X0 Y0 Z20 M3 S500
G99 G83.1 X5 Z-15 R2 Q6 E1 F100
G86.1 X10 I-1 Z-5 R2
G80
G84.1 X15 Z-5 R2 F100
G80
M30
=== truth
0 0 20 rapid
5 0 20 rapid
5 0 2 rapid
5 0 -4 feed
5 0 -3 rapid
5 0 -10 feed
5 0 -9 rapid
5 0 -15 feed
5 0 2 rapid
10 0 2 rapid
10 0 -5 feed
9 0 -5 rapid
9 0 2 rapid
10 0 2 rapid
15 0 2 rapid
15 0 -5 thread
15 0 2 thread
=== expect
file 0 main.nc
1: event spindle rpm=500 direction="cw"
1: rapid from 0 0 0 to 0 0 20 t0.08
2: rapid to 5 0 20 t0.02
2: rapid to 5 0 2 t0.072
2: feed to 5 0 -4 F100 t3.6
2: rapid to 5 0 -3 t0.004
2: feed to 5 0 -10 F100 t4.2
2: rapid to 5 0 -9 t0.004
2: feed to 5 0 -15 F100 t3.6
2: rapid to 5 0 2 t0.068
3: rapid to 10 0 2 t0.02
3: feed to 10 0 -5 F100 t4.2
3: event spindle rpm=0 direction="oriented"
3: rapid to 9 0 -5 t0.004
3: rapid to 9 0 2 t0.028
3: rapid to 10 0 2 t0.004
3: event spindle rpm=500 direction="cw"
5: rapid to 15 0 2 t0.02
main.nc:5:1: warning[nct-tap-start]: G84.1 taps with the spindle turning backwards: program M4 before the cycle
    G84.1 X15 Z-5 R2 F100
    ^~~~~~~~~~~~~~~~~~~~~
5: thread to 15 0 -5 F100 t4.2
5: event spindle rpm=500 direction="cw"
5: thread to 15 0 2 F100 t4.2
5: event spindle rpm=500 direction="ccw"
7: event end code="M30"
end of program: 7 blocks, 17 motions, 0 errors, 1 warnings
