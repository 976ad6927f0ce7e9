=== about
Feeds per revolution, constant cutting speed with its limit, dwell, exact stop.
proves: wl4-5.13-G94 wl4-5.13-G95 wl4-5.14-G96 wl4-5.14-G97 wl4-5.12-G51S wl4-4.2-F wl4-4.2-S wl4-7.2-S wl4-7.1-F wl4-5.6-G60 wl4-5.6-G64 wl4-4.2-E wl4-9.2-105 wl4-9.2-106 wl4-9.2-120
=== settings
control = wl4-lathe
=== main
%TIMES
G54 G0 X100 Z0
G97 S500 M3 G95 F0.2
G1 Z-10
G94 F60
G60 Z-20
G64 G96 S100 G95 F0.2
Z-30
G51 S200
Z-40
M41
Z-50
G4 E1.5
G94 X#105 Z(-#106) F#120
M30
%
=== truth
rapid 50 0 0
feed 50 0 -10 F 100
feed 50 0 -20 F 60
feed 50 0 -30 F 63.6620
feed 50 0 -40 F 40
feed 50 0 -50 F 63.6620
feed 47.5 0 -96 F 100
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 50 0 0 t0.2
3: event spindle rpm=500 direction="cw"
4: feed to 50 0 -10 F100 t6
6: feed to 50 0 -20 F60 t10
7: event spindle rpm=318.3098861837907 direction="cw"
8: feed to 50 0 -30 F63.662 t9.4248
9: event spindle rpm=200 direction="cw"
10: feed to 50 0 -40 F40 t15
11: event function code="M41"
11: event spindle rpm=318.3098861837907 direction="cw"
12: feed to 50 0 -50 F63.662 t9.4248
13: event dwell seconds=1.5
14: feed to 47.5 0 -96 F100 t27.6407
15: event end code="M30"
end of program: 14 blocks, 7 motions, 0 errors, 0 warnings
