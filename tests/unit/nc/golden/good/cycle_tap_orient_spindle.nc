=== about
N1503.TSC = 1: M19 before the tap, and the spindle turns with the axis all the same; it stays at the angle. With a
floating chuck the way out turns the other way round, at constant surface speed too.
proves: nct-18.1.9-TSC nct-18.1.9-G84.2 nct-18.1.9-G84.3
=== settings
N1503.TSC = 1
spindle = 1 acceleration 1000 position CS1
=== main
G0 Z2 S500 M3
G99 G84.2 X10 Z-10 R2 F500
G80 CS1=90
G84.3 X20 Z-10 R2
G80 S500 M3
G84 X30 Z-10 R2
G80 M4
G74 X40 Z-10 R2
G80 G96 S31.4159265358979 P1
G74 X10 Z-10 R2
M30
=== truth
rapid 0 0 2 S 500
rapid 10 0 2 S 500
thread 10 0 -10 t 1.94 S 500
thread 10 0 2 t 1.94 S -500
rapid 20 0 2 S 0
thread 20 0 -10 t 1.94 S -500
thread 20 0 2 t 1.94 S 500
rapid 30 0 2 S 500
thread 30 0 -10 S 500
thread 30 0 2 S -500
rapid 40 0 2 S -500
thread 40 0 -10 S -500
thread 40 0 2 S 500
rapid 10 0 2 S -125
thread 10 0 -10 S -200
thread 10 0 2 S 200
=== says
direction="oriented"
angle=90
direction="oriented"
direction="cw"
=== expect
file 0 main.nc
1: event spindle rpm=500 direction="cw"
1: rapid from 0 0 0 to 0 0 2 t0.008
2: rapid to 10 0 2 t0.04
2: event spindle rpm=0 direction="oriented"
2: thread to 10 0 -10 F500 t1.94
2: thread to 10 0 2 F500 t1.94
3: event spindle rpm=0 direction="positioned" angle=90 turn=90
4: rapid to 20 0 2 t0.04
4: event spindle rpm=0 direction="oriented"
4: thread to 20 0 -10 F500 t1.94
4: thread to 20 0 2 F500 t1.94
5: event spindle rpm=500 direction="cw"
6: rapid to 30 0 2 t0.04
6: thread to 30 0 -10 F500 t1.44
6: event spindle rpm=500 direction="ccw"
6: thread to 30 0 2 F500 t1.44
6: event spindle rpm=500 direction="cw"
7: event spindle rpm=500 direction="ccw"
8: rapid to 40 0 2 t0.04
8: thread to 40 0 -10 F500 t1.44
8: event spindle rpm=500 direction="cw"
8: thread to 40 0 2 F500 t1.44
8: event spindle rpm=500 direction="ccw"
9: event spindle rpm=124.99999999999986 direction="ccw"
10: rapid to 10 0 2 t0.12
10: thread to 10 0 -10 F500 t1.44
10: event spindle rpm=124.99999999999986 direction="cw"
10: thread to 10 0 2 F500 t1.44
10: event spindle rpm=124.99999999999986 direction="ccw"
11: event end code="M30"
end of program: 11 blocks, 16 motions, 0 errors, 0 warnings
