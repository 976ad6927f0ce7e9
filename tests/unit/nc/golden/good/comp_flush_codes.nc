=== about
Codes that empty the buffer: the block before runs to the programmed point, the one behind it starts there. Spindle, coolant and calls do not.
proves: nct-15.5.2-flush
=== settings
D1 = 5
reference1 = 0 0 0
reference2 = 0 0 0
=== main
G0 X-50
G41 D1 G1 X0 F100
X10
X20
G54
X30
X40
G55
X50
X60
G54.1 P1
X70
X80
G52 X0
X90
X100
G92 Y0
X110
X120
G53 Z0
X130
X140
G28 Z0
X150
X160
G30 P2 Z0
X170
X180
G43 H0
X190
X200
M0
X210
X220
M1
X230
X240
G44 H0
X250
X260
G49
X270
X280
T5 M6
X290
S100 M3
X300
M98 P11
X310
G40 X330
M30
=== sub O0011
M99
=== truth
-50 0 0
0 5 0
10 5 0
20 0 0
30 5 0
40 0 0
50 5 0
60 0 0
70 5 0
80 0 0
90 5 0
100 0 0
110 5 0
120 0 0
130 5 0
140 0 0
150 5 0
160 0 0
170 5 0
180 0 0
190 5 0
200 0 0
210 5 0
220 0 0
230 5 0
240 0 0
250 5 0
260 0 0
270 5 0
280 0 0
290 5 0
300 5 0
310 5 0
330 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -50 0 0 t0.2
2: feed to 0 5 0 F100 t30.1496
3: feed to 10 5 0 F100 t6
4: feed to 20 0 0 F100 t6.7082
main.nc:8:1: warning[nct-offset-missing]: G55 has no value in the job: 0 is taken (--offset G55=X,Y,Z)
    G55
    ^~~
6: feed to 30 5 0 F100 t6.7082
7: feed to 40 0 0 F100 t6.7082
main.nc:11:1: warning[nct-offset-missing]: G54.1 P1 has no value in the job: 0 is taken (--offset G54.1P1=X,Y,Z)
    G54.1 P1
    ^~~~~~~~
9: feed to 50 5 0 F100 t6.7082
10: feed to 60 0 0 F100 t6.7082
12: feed to 70 5 0 F100 t6.7082
13: feed to 80 0 0 F100 t6.7082
15: feed to 90 5 0 F100 t6.7082
16: feed to 100 0 0 F100 t6.7082
18: feed to 110 5 0 F100 t6.7082
19: feed to 120 0 0 F100 t6.7082
21: feed to 130 5 0 F100 t6.7082
22: feed to 140 0 0 F100 t6.7082
24: feed to 150 5 0 F100 t6.7082
25: feed to 160 0 0 F100 t6.7082
27: feed to 170 5 0 F100 t6.7082
28: feed to 180 0 0 F100 t6.7082
30: feed to 190 5 0 F100 t6.7082
31: feed to 200 0 0 F100 t6.7082
32: event stop code="M0"
33: feed to 210 5 0 F100 t6.7082
34: feed to 220 0 0 F100 t6.7082
35: event optional_stop code="M1" active=false
36: feed to 230 5 0 F100 t6.7082
37: feed to 240 0 0 F100 t6.7082
39: feed to 250 5 0 F100 t6.7082
40: feed to 260 0 0 F100 t6.7082
42: feed to 270 5 0 F100 t6.7082
43: feed to 280 0 0 F100 t6.7082
44: event tool tool=5
file 1 O0011
45: feed to 290 5 0 F100 t6.7082
46: event spindle rpm=100 direction="cw"
47: feed to 300 5 0 F100 t6
49: feed to 310 5 0 F100 t6
50: feed to 330 0 0 F100 t12.3693
51: event end code="M30"
end of program: 52 blocks, 34 motions, 0 errors, 2 warnings
