=== about
proves: nct-18.1.2-G74 nct-18.1.8-G84 nct-18.1.9-G84.2 nct-18.1.9-G84.3 nct-18.1.10-G84.2Q nct-3-G74 nct-3-G84 nct-3-G84.2 nct-3-G84.3
=== main
G0 Z50 S100 M4
G98 G74 X10 Z-20 R2 P1 F100
M3
G99 G84 X20 F100
G84.2 X30
G84.3 X40
G84.2 X50 Q8 E1
G80
M30
=== truth
0 0 50
10 0 50
10 0 2
thread 10 0 -20
thread 10 0 2
rapid 10 0 50
20 0 50
20 0 2
thread 20 0 -20
thread 20 0 2
30 0 2
thread 30 0 -20
thread 30 0 2
40 0 2
thread 40 0 -20
thread 40 0 2
50 0 2
thread 50 0 -6
thread 50 0 -5
thread 50 0 -14
thread 50 0 -13
thread 50 0 -20
thread 50 0 2
=== expect
file 0 main.nc
1: event spindle rpm=100 direction="ccw"
1: rapid from 0 0 0 to 0 0 50 t0.2
2: rapid to 10 0 50 t0.04
2: rapid to 10 0 2 t0.192
2: thread to 10 0 -20 F100 t13.2
2: event dwell seconds=1
2: event spindle rpm=100 direction="cw"
2: thread to 10 0 2 F100 t13.2
2: event spindle rpm=100 direction="ccw"
2: rapid to 10 0 50 t0.192
3: event spindle rpm=100 direction="cw"
4: rapid to 20 0 50 t0.04
4: rapid to 20 0 2 t0.192
4: thread to 20 0 -20 F100 t13.2
4: event dwell seconds=1
4: event spindle rpm=100 direction="ccw"
4: thread to 20 0 2 F100 t13.2
4: event spindle rpm=100 direction="cw"
5: rapid to 30 0 2 t0.04
5: event spindle rpm=0 direction="position loop"
5: thread to 30 0 -20 F100 t13.2
5: event dwell seconds=1
5: thread to 30 0 2 F100 t13.2
6: rapid to 40 0 2 t0.04
6: event spindle rpm=0 direction="position loop"
6: thread to 40 0 -20 F100 t13.2
6: event dwell seconds=1
6: thread to 40 0 2 F100 t13.2
7: rapid to 50 0 2 t0.04
7: event spindle rpm=0 direction="position loop"
7: thread to 50 0 -6 F100 t4.8
7: thread to 50 0 -5 F100 t0.6
7: thread to 50 0 -14 F100 t5.4
7: thread to 50 0 -13 F100 t0.6
7: thread to 50 0 -20 F100 t4.2
7: event dwell seconds=1
7: thread to 50 0 2 F100 t13.2
9: event end code="M30"
end of program: 9 blocks, 23 motions, 0 errors, 0 warnings
