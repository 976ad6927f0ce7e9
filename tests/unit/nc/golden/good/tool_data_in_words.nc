=== about
A macro beside M6 sets H, D, S, F of the tool in the spindle; with an empty spindle the values are vacant and the words are not there.
proves: nct-23.1.20-#8400 nct-23.1.20-#8401
=== settings
H5 = 5
H12 = 12.5
D23 = 3
=== main
G10 L75 P1
N2
T81501070 Q10001 A0 B2 C131 L200 H12 D23 S1500 F250
G11
G0 G43 H5 Z0
M98 P9
Z1
T81501070 M6
M98 P9
Z1 M3
G1 X10
G41 X20 Y0
X30
G40 X40
M30
=== sub O0009
#8400=10
H#8409 D#8410 S#8411 F#8412
M99
=== truth
0 0 5
0 0 6
0 0 13.5
feed 10 0 13.5 F 250 S 1500
20 3 13.5
30 3 13.5
40 0 13.5
=== expect
file 0 main.nc
5: rapid from 0 0 0 to 0 0 5 t0.02
file 1 O0009
7: rapid to 0 0 6 t0.004
8: event tool tool=81501070 row=2
10: event spindle rpm=1500 direction="cw"
10: rapid to 0 0 13.5 t0.03
11: feed to 10 0 13.5 F250 t2.4
12: feed to 20 3 13.5 F250 t2.5057
13: feed to 30 3 13.5 F250 t2.4
14: feed to 40 0 13.5 F250 t2.5057
15: event end code="M30"
end of program: 20 blocks, 7 motions, 0 errors, 0 warnings
