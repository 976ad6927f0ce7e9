=== about
100 m/min at diameter 260: 122.43 rpm. G96 S300 P4: axis 4 gives the radius. G97 keeps the last speed; the speed of a named
spindle.
proves: nct-11.5.1-G96 nct-11.5.1-G97 nct-5.3-DIA
=== settings
N0106.DIA.1 = 1
N0687 = 1
axis = U 4 linear parallel X
spindle = 1 name S1
spindle = 2 name S2
=== main
G0 X100
G96 S100 M3
G97 S1500
G1 Y1 F100
G96 X260
Y2
G97
Y3
G0 U50
G96 S300 P4
G1 Y4
G97 S2=1200
M3
M30
=== truth
50 0 0
50 1 0 S 1500
130 1 0
130 2 0 S 122.4269
130 3 0 S 122.4269
180 3 0
180 4 0 S 954.9297
=== says
spindle rpm=1200 direction="cw" spindle=2
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 50 0 0 t0.2
2: event spindle rpm=318.3098861837907 direction="cw" spindle=1
3: event spindle rpm=1500 direction="cw" spindle=1
4: feed to 50 1 0 F100 t0.6
5: event spindle rpm=318.3098861837907 direction="cw" spindle=1
5: feed to 130 1 0 F100 t48
6: feed to 130 2 0 F100 t0.6
7: event spindle rpm=122.42687930145796 direction="cw" spindle=1
8: feed to 130 3 0 F100 t0.6
9: rapid to 180 3 0 t0.2
10: event spindle rpm=954.9296585513721 direction="cw" spindle=1
11: feed to 180 4 0 F100 t0.6
12: event spindle rpm=954.9296585513721 direction="cw" spindle=1
13: event spindle rpm=1200 direction="cw" spindle=2
14: event end code="M30"
end of program: 14 blocks, 7 motions, 0 errors, 0 warnings
