=== about
R: radius of an arc, level and increment of level of a cycle, angle and increment of angle of a rotation, value of a table row.
I, J, K: centres in three planes, vector at the start of compensation, shift of a cycle, factors of scaling, angles of a basic rotation.
F: feed, lead of a thread, which leaves the feed alone. P: dwell, program, factor, number of a reference point and of a work system.
proves: nct-1.1-R nct-1.1-IJK nct-1.1-F nct-1.1-P
=== settings
reference2 = 7 8 9
=== main
G17 G0 X10 Y0 Z10 S600 M3
G2 X20 R5 F120
G81 X30 Z-1 R2
X40 RI-7
G80
G68 X0 Y0 R90
G1 X10 Y5 Z10
G68 X0 Y0 RI90
X10 Y5
G69
G0 X0 Y0 Z0
G3 X0 Y20 J10
G18 G3 Z20 X0 K10
G18 G3 Z10 X10 I0 K-10
G19 G3 Y30 Z20 J0 K10
G17 G0 X0 Y0 Z0
G10 L12 P1 R3
G41 G1 X10 I1 J1 D1
Y20
G40 X0
Y0
G99 G76 X5 Z-2 R0 I1 J2 K0
G80
G51 X0 Y0 Z0 I2 J3 K4
X1 Y1 Z1
G50
G33 Z0 F2
G1 X20
#3001=0
G4 P3
G0 X[#3001/1000]
M98 P11
G51 X0 Y0 Z0 P10
X2
G50
G30 Z5 P2
G10 L2 P2 I90
G0 G55 X1 Y2
G10 L20 P5 X100
G54.1 P5 X1
M30
=== sub O0011
G91 X1
G90
M99
=== truth
10 0 10
20 0 10 center 15 0 10 sweep -180 F 120
30 0 10
30 0 2
30 0 -1
30 0 10
40 0 10
40 0 3
40 0 -1
40 0 10
-5 10 10
-10 -5 10
0 0 0
0 20 0 center 0 10 0 sweep 180
0 20 20 center 0 20 10 sweep 180
10 20 10 center 0 20 10 sweep 90
10 30 20 center 10 20 20 sweep 90
rapid 0 0 0
7 1.2426 0
7 20 0
0 20 0
0 0 0
5 0 0
feed 5 0 -2
6 2 -2
6 2 0
5 0 0
feed 2 3 4 F 120
thread 2 3 0 F 1200
feed 20 3 0 F 120
3 3 0
4 3 0
20 3 0
20 3 5
20 3 9
-2 1 9
101 1 9
=== expect
file 0 main.nc
1: event spindle rpm=600 direction="cw"
1: rapid from 0 0 0 to 10 0 10 t0.04
2: feed arc to 20 0 10 center 15 0 10 normal 0 0 1 sweep -180 F120 t7.854
3: rapid to 30 0 10 t0.04
3: rapid to 30 0 2 t0.032
3: feed to 30 0 -1 F120 t1.5
3: rapid to 30 0 10 t0.044
4: rapid to 40 0 10 t0.04
4: rapid to 40 0 3 t0.028
4: feed to 40 0 -1 F120 t2
4: rapid to 40 0 10 t0.044
7: feed to -5 10 10 F120 t23.0489
9: feed to -10 -5 10 F120 t7.9057
11: rapid to 0 0 0 t0.04
12: feed arc to 0 20 0 center 0 10 0 normal 0 0 1 sweep 180 F120 t15.708
13: feed arc to 0 20 20 center 0 20 10 normal 0 1 0 sweep 180 F120 t15.708
14: feed arc to 10 20 10 center 0 20 10 normal 0 1 0 sweep 90 F120 t7.854
15: feed arc to 10 30 20 center 10 20 20 normal 1 0 0 sweep 90 F120 t7.854
16: rapid to 0 0 0 t0.12
18: feed to 7 1.2426 0 F120 t3.5547
19: feed to 7 20 0 F120 t9.3787
20: feed to 0 20 0 F120 t3.5
21: feed to 0 0 0 F120 t10
main.nc:22:25: warning[nct-unused-word]: K0 does nothing in this block of G76: the cycle does not read K; repeats are programmed with L
    G99 G76 X5 Z-2 R0 I1 J2 K0
                            ^~
22: rapid to 5 0 0 t0.02
22: feed to 5 0 -2 F120 t1
22: event spindle rpm=0 direction="oriented"
22: rapid to 6 2 -2 t0.008
22: rapid to 6 2 0 t0.008
22: rapid to 5 0 0 t0.008
22: event spindle rpm=600 direction="cw"
25: feed to 2 3 4 F120 t2.9155
27: event thread lead=2 angle=0
27: thread to 2 3 0 F1200 t0.2
28: feed to 20 3 0 F120 t9
30: event dwell seconds=3
31: rapid to 3 3 0 t0.068
file 1 O0011
1/1 depth 1: rapid to 4 3 0 t0.004
34: rapid to 20 3 0 t0.064
36: rapid to 20 3 5 t0.02
36: rapid to 20 3 9 t0.016
main.nc:38:1: warning[nct-offset-missing]: G55 has no value in the job: 0 is taken (--offset G55=X,Y,Z)
    G0 G55 X1 Y2
    ^~~~~~~~~~~~
38: rapid to -2 1 9 t0.088
40: rapid to 101 1 9 t0.412
41: event end code="M30"
end of program: 44 blocks, 37 motions, 0 errors, 2 warnings
