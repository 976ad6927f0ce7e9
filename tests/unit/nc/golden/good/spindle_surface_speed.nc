=== about
The listings of 8.5; X is a radius. 100 m/min at radius 260: 61.2134 rpm; at 130: 122.4268.
proves: nct-3-G96 nct-3-G97 nct-11.5.1-G96 nct-11.5.1-G97
=== settings
N0687 = 1
=== main
G0 X130
G96 S100 M3
G1 F100 Y10
G97 S1500
Y20
G96 X260
Y30
G97
Y40
G96
(rapids end at the speed of their end point)
G0 X130
G1 Y50
M30
=== truth
130 0 0 S 0
130 10 0 S 122.4269
130 20 0 S 1500
260 20 0 S 81.6179
260 30 0 S 61.2134
260 40 0 S 61.2134
130 40 0 S 61.2134
130 50 0 S 122.4269
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 130 0 0 t0.52
2: event spindle rpm=122.42687930145796 direction="cw"
3: feed to 130 10 0 F100 t6
4: event spindle rpm=1500 direction="cw"
5: feed to 130 20 0 F100 t6
6: event spindle rpm=122.42687930145796 direction="cw"
6: feed to 260 20 0 F100 t78
7: feed to 260 30 0 F100 t6
8: event spindle rpm=61.21343965072898 direction="cw"
9: feed to 260 40 0 F100 t6
12: rapid to 130 40 0 t0.52
12: event spindle rpm=122.42687930145796 direction="cw"
13: feed to 130 50 0 F100 t6
14: event end code="M30"
end of program: 13 blocks, 8 motions, 0 errors, 0 warnings
