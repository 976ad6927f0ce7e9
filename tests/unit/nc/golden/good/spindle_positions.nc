=== about
The tests of 8.7: absolute positions go the shorter way, steps keep whole turns; M codes index.
proves: nct-11.7.1-M19 nct-11.7.2-M24 nct-11.7.3-pos nct-11.7.3-index nct-11.7.5-off
=== settings
spindle = 1 name S1
spindle = 2 name S2 position CS2 positioning 60
N0820.2 = 201
N0821.2 = 20
N0822.2 = 18
N0823.2 = 24
=== main
S2=0 M19
G90 CS2=30
CS2=750
CS2=270
S2=0 M24
G91 CS2=3600
CS2=I3600
G90
S2=0 M19
M205
M210
M220
S2=500 M3
G4 P1
M30
=== truth
=== says
direction="oriented" spindle=2
angle=30
angle=30
angle=270
direction="position loop" spindle=2
turn=3600
turn=3600
direction="oriented"
angle=90
angle=270
turn=360
spindle rpm=500
=== expect
file 0 main.nc
1: event spindle rpm=0 direction="oriented" spindle=2
2: event spindle rpm=0 direction="positioned" spindle=2 angle=30 turn=30
3: event spindle rpm=0 direction="positioned" spindle=2 angle=30 turn=0
4: event spindle rpm=0 direction="positioned" spindle=2 angle=270 turn=-120
5: event spindle rpm=0 direction="position loop" spindle=2
6: event spindle rpm=0 direction="positioned" spindle=2 angle=270 turn=3600
7: event spindle rpm=0 direction="positioned" spindle=2 angle=270 turn=3600
9: event spindle rpm=0 direction="oriented" spindle=2
10: event spindle rpm=0 direction="positioned" spindle=2 angle=90 turn=90
11: event spindle rpm=0 direction="positioned" spindle=2 angle=270 turn=180
12: event spindle rpm=0 direction="positioned" spindle=2 angle=270 turn=360
13: event spindle rpm=500 direction="cw" spindle=2
14: event dwell seconds=1
15: event end code="M30"
end of program: 15 blocks, 0 motions, 0 errors, 0 warnings
