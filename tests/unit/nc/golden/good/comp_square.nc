=== about
proves: nct-15.5-G42 nct-15.5-G40 nct-15.1-D nct-15.5.3-G40 nct-3-G42 nct-3-G40
=== settings
D1 = 5
H1 = 0
=== main
N10 G54 G17 G49 M3 S500
N20 G0 X-40 Y-40
N30 G43 Z2 H1
N40 G1 Z-5 F500
N50 G42 G0 X0 Y0 D1
N60 G1 X60
N70 Y60
N80 X0
N90 Y0
N100 G40 G0 X-40 Y-40
N110 M30
=== truth
rapid -40 -40 0
rapid -40 -40 2
feed -40 -40 -5
rapid 0 -5 -5
feed 65 -5 -5
feed 65 65 -5
feed -5 65 -5
feed -5 0 -5
rapid -40 -40 -5
=== expect
file 0 main.nc
1 N10: event spindle rpm=500 direction="cw"
2 N20: rapid from 0 0 0 to -40 -40 0 t0.16
3 N30: rapid to -40 -40 2 t0.008
4 N40: feed to -40 -40 -5 F500 t0.84
5 N50: rapid to 0 -5 -5 t0.16
6 N60: feed to 65 -5 -5 F500 t7.8
7 N70: feed to 65 65 -5 F500 t8.4
8 N80: feed to -5 65 -5 F500 t8.4
9 N90: feed to -5 0 -5 F500 t7.8
10 N100: rapid to -40 -40 -5 t0.16
11 N110: event end code="M30"
end of program: 11 blocks, 9 motions, 0 errors, 0 warnings
