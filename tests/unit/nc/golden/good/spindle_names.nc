=== about
The listing of 8.2: codes go to the spindle that was named last. Only the main spindle (N0604) is that of the motions.
proves: nct-1.1-S nct-11.1.1-SP nct-11.1.1-Sname nct-11.1-S nct-11.1.2-channel nct-11.7.1-M19 nct-11.2-M3 nct-11.2-M4 nct-11.2-M5
=== settings
spindle = 1 name S1
spindle = 2 name S2
=== main
S1=1500 M4
S2=2000 M3
G1 X10 F100
M5
M19
S1=0 M5
X20
(plain S is the default spindle, S with P any)
S700 P2
M3
S800 M3
X30
S900
X40
M30
=== truth
10 0 0 S -1500
20 0 0 S 0
30 0 0 S 800
40 0 0 S 900
=== says
spindle rpm=1500 direction="ccw" spindle=1
spindle rpm=2000 direction="cw" spindle=2
direction="stop" spindle=2
direction="oriented" spindle=2
direction="stop" spindle=1
=== expect
file 0 main.nc
1: event spindle rpm=1500 direction="ccw" spindle=1
2: event spindle rpm=2000 direction="cw" spindle=2
3: feed from 0 0 0 to 10 0 0 F100 t6
4: event spindle rpm=0 direction="stop" spindle=2
5: event spindle rpm=0 direction="oriented" spindle=2
6: event spindle rpm=0 direction="ccw" spindle=1
6: event spindle rpm=0 direction="stop" spindle=1
7: feed to 20 0 0 F100 t6
10: event spindle rpm=700 direction="cw" spindle=2
11: event spindle rpm=800 direction="cw" spindle=1
12: feed to 30 0 0 F100 t6
13: event spindle rpm=900 direction="cw" spindle=1
14: feed to 40 0 0 F100 t6
15: event end code="M30"
end of program: 14 blocks, 4 motions, 0 errors, 0 warnings
