=== about
The spindle of rigid taps (18.1.9): it turns into the thread and back out of it, faster where the way out is
faster (pitch = F/S on every way), comes to a stand at the loop's closing and stays so until M3. The spindle takes
1000 rpm a second: stop from 500 rpm 0.5 s; a way of 12 mm at 500 mm/min (pitch 1) takes 12/(500/60) + 0.5 s.
proves: nct-18.1.9-TSC nct-18.1.9-G84.2 nct-18.1.9-G84.3 nct-3-G84.2 nct-3-G84.3
=== settings
spindle = 1 acceleration 1000
N0823 = 24
=== main
G0 Z2 S500 M3
G99 G84.2 X10 Z-10 R2 F500
G84.3 X20
S250 G95 X30 F1
G80
G94 G1 X40 F100
G10 L52
N1503 Q4 R1
N1506 R200
N1503 Q3 R1
N1507 R300
N1503 Q5 R1
G11
S500 G84.3 X50 Z-10 R2 Q6 E2 F500
G80
G10 L52
N1503 Q3 R0
G11
G84.2 X60 Z-10 R2 Q6 E2 F500
S600 M3
G80 G1 X70
M30
=== truth
rapid 0 0 2 S 500
rapid 10 0 2 S 500
thread 10 0 -10 F 500 t 1.94 S 500
thread 10 0 2 F 500 t 1.94 S -500
rapid 20 0 2 S 0
thread 20 0 -10 F 500 t 1.94 S -500
thread 20 0 2 F 500 t 1.94 S 500
rapid 30 0 2 S 0
thread 30 0 -10 F 250 t 3.13 S -250
thread 30 0 2 F 250 t 3.13 S 250
feed 40 0 2 S 0
rapid 50 0 2 S 0
thread 50 0 -4 F 500 S -500
thread 50 0 2 F 1500 S 1500
thread 50 0 -2 F 1500 S -1500
thread 50 0 -10 F 500 S -500
thread 50 0 2 F 1000 S 1000
rapid 60 0 2 S 0
thread 60 0 -4 F 500 S 500
thread 60 0 -2 F 500 S -500
thread 60 0 -10 F 500 S 500
thread 60 0 2 F 1000 S -1000
feed 70 0 2 S 600
=== says
spindle rpm=0 direction="position loop" code="M24"
=== expect
file 0 main.nc
1: event spindle rpm=500 direction="cw"
1: rapid from 0 0 0 to 0 0 2 t0.008
2: rapid to 10 0 2 t0.04
2: event spindle rpm=0 direction="position loop" code="M24"
2: thread to 10 0 -10 F500 t1.94
2: thread to 10 0 2 F500 t1.94
3: rapid to 20 0 2 t0.04
3: event spindle rpm=0 direction="position loop" code="M24"
3: thread to 20 0 -10 F500 t1.94
3: thread to 20 0 2 F500 t1.94
4: rapid to 30 0 2 t0.04
4: event spindle rpm=0 direction="position loop" code="M24"
4: thread to 30 0 -10 F250 t3.13
4: thread to 30 0 2 F250 t3.13
6: feed to 40 0 2 F100 t6
14: rapid to 50 0 2 t0.04
14: event spindle rpm=0 direction="position loop" code="M24"
14: thread to 50 0 -4 F500 t1.22
14: thread to 50 0 2 F1500 t1.2
14: thread to 50 0 -2 F1500 t0.9798
14: thread to 50 0 -10 F500 t1.46
14: thread to 50 0 2 F1000 t1.6971
19: rapid to 60 0 2 t0.04
19: event spindle rpm=0 direction="position loop" code="M24"
19: thread to 60 0 -4 F500 t1.22
19: thread to 60 0 -2 F500 t0.6928
19: thread to 60 0 -10 F500 t1.46
19: thread to 60 0 2 F1000 t1.6971
20: event spindle rpm=600 direction="cw"
21: feed to 70 0 2 F500 t1.2
22: event end code="M30"
end of program: 22 blocks, 23 motions, 0 errors, 0 warnings
