=== about
Codes and functions that stop look-ahead end the block before on its programmed point; the next block starts there and ends on its corner
(2.868 behind and before the corner, 10 above). Other functions leave the corner as it is.
proves: nct-15.5.2-flush nct-13.3-flush nct-15.5.2-passthrough
=== settings
D1 = 10
H1 = 0
N1333 = 66
BUF.M1 = 90
BUF.LOW1 = 100
BUF.HIGH1 = 110
BUF.A1 = 1
BUF.S = 1
BUF.T = 1
=== main
G0 X-100
G41 G1 X-50 D1 F1000
X0
G91
X80 Y-50
G23
X80 Y50
X40
X80 Y-50
G54
X80 Y50
X40
X80 Y-50
G52 X0 Y0
X80 Y50
X40
X80 Y-50
M0
X80 Y50
X40
X80 Y-50
M1
X80 Y50
X40
X80 Y-50
G43 H1
X80 Y50
X40
X80 Y-50
G49
X80 Y50
X40
X80 Y-50
M90
X80 Y50
X40
X80 Y-50
M105
X80 Y50
X40
X80 Y-50
S500
X80 Y50
X40
X80 Y-50
T3
X80 Y50
X40
X80 Y-50
B7
X80 Y50
X40
X80 Y-50
M91
X80 Y50
X40
X80 Y-50
G4 P1
X80 Y50
X40
X80 Y-50
F900
X80 Y50
X40
G40 X50
M30
=== truth
-100 0 0
-50 10 0
2.868 10 0
80 -50 0
157.132 10 0
202.868 10 0
280 -50 0
357.132 10 0
402.868 10 0
480 -50 0
557.132 10 0
602.868 10 0
680 -50 0
757.132 10 0
802.868 10 0
880 -50 0
957.132 10 0
1002.868 10 0
1080 -50 0
1157.132 10 0
1202.868 10 0
1280 -50 0
1357.132 10 0
1402.868 10 0
1480 -50 0
1557.132 10 0
1602.868 10 0
1680 -50 0
1757.132 10 0
1802.868 10 0
1880 -50 0
1957.132 10 0
2002.868 10 0
2080 -50 0
2157.132 10 0
2202.868 10 0
2280 -50 0
2357.132 10 0
2402.868 10 0
2480 -38.2075 0
2557.132 10 0
2602.868 10 0
2680 -38.2075 0
2757.132 10 0
2802.868 10 0
2880 -38.2075 0
2957.132 10 0
3000 10 0
3050 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: feed to -50 10 0 F1000 t3.0594
3: feed to 2.868 10 0 F1000 t3.1721
5: feed to 80 -50 0 F1000 t5.8632
7: feed to 157.132 10 0 F1000 t5.8632
8: feed to 202.868 10 0 F1000 t2.7442
9: feed to 280 -50 0 F1000 t5.8632
11: feed to 357.132 10 0 F1000 t5.8632
12: feed to 402.868 10 0 F1000 t2.7442
13: feed to 480 -50 0 F1000 t5.8632
15: feed to 557.132 10 0 F1000 t5.8632
16: feed to 602.868 10 0 F1000 t2.7442
17: feed to 680 -50 0 F1000 t5.8632
18: event stop code="M0"
19: feed to 757.132 10 0 F1000 t5.8632
20: feed to 802.868 10 0 F1000 t2.7442
21: feed to 880 -50 0 F1000 t5.8632
22: event optional_stop code="M1" active=false
23: feed to 957.132 10 0 F1000 t5.8632
24: feed to 1002.868 10 0 F1000 t2.7442
25: feed to 1080 -50 0 F1000 t5.8632
27: feed to 1157.132 10 0 F1000 t5.8632
28: feed to 1202.868 10 0 F1000 t2.7442
29: feed to 1280 -50 0 F1000 t5.8632
main.nc:34:1: warning[nct-m-function]: M90 is a function of the machine builder: it has no effect in the simulation
    M90
    ^~~
31: feed to 1357.132 10 0 F1000 t5.8632
32: feed to 1402.868 10 0 F1000 t2.7442
33: feed to 1480 -50 0 F1000 t5.8632
34: event function code="M90"
main.nc:38:1: warning[nct-m-function]: M105 is a function of the machine builder: it has no effect in the simulation
    M105
    ^~~~
35: feed to 1557.132 10 0 F1000 t5.8632
36: feed to 1602.868 10 0 F1000 t2.7442
37: feed to 1680 -50 0 F1000 t5.8632
38: event function code="M105"
39: feed to 1757.132 10 0 F1000 t5.8632
40: feed to 1802.868 10 0 F1000 t2.7442
41: feed to 1880 -50 0 F1000 t5.8632
43: feed to 1957.132 10 0 F1000 t5.8632
44: feed to 2002.868 10 0 F1000 t2.7442
45: feed to 2080 -50 0 F1000 t5.8632
47: feed to 2157.132 10 0 F1000 t5.8632
48: feed to 2202.868 10 0 F1000 t2.7442
49: feed to 2280 -50 0 F1000 t5.8632
50: event function code="B7"
main.nc:54:1: warning[nct-m-function]: M91 is a function of the machine builder: it has no effect in the simulation
    M91
    ^~~
51: feed to 2357.132 10 0 F1000 t5.8632
52: feed to 2402.868 10 0 F1000 t2.7442
53: feed to 2480 -38.2075 0 F1000 t5.4575
54: event function code="M91"
55: feed to 2557.132 10 0 F1000 t5.4575
56: feed to 2602.868 10 0 F1000 t2.7442
57: feed to 2680 -38.2075 0 F1000 t5.4575
58: event dwell seconds=1
59: feed to 2757.132 10 0 F1000 t5.4575
60: feed to 2802.868 10 0 F1000 t2.7442
61: feed to 2880 -38.2075 0 F1000 t5.4575
63: feed to 2957.132 10 0 F900 t6.0639
64: feed to 3000 10 0 F900 t2.8579
65: feed to 3050 0 0 F900 t3.3993
66: event end code="M30"
end of program: 66 blocks, 49 motions, 0 errors, 3 warnings
