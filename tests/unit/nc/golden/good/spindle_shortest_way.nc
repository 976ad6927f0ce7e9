=== about
The manual's angles from the orientation at 0: 30 and 750 turn by 30, 270 by -90; M201 to M203 turn by 18, 36 and 54, M220 by 360.
proves: nct-11.7.3-pos nct-11.7.3-index nct-11.7.1-M19
=== settings
spindle = 1 name S1
spindle = 2 name S2 position CS2 positioning 60
N0820.2 = 201
N0821.2 = 20
N0822.2 = 18
=== main
S2=0 M19
G90 CS2=30
S2=0 M19
CS2=750
S2=0 M19
CS2=270
S2=0 M19
M201
M202
M203
M220
M30
=== says
angle=30 turn=30
angle=30 turn=30
angle=270 turn=-90
angle=18 turn=18
angle=54 turn=36
angle=108 turn=54
angle=108 turn=360
=== expect
file 0 main.nc
1: event spindle rpm=0 direction="oriented" spindle=2
2: event spindle rpm=0 direction="positioned" spindle=2 angle=30 turn=30
3: event spindle rpm=0 direction="oriented" spindle=2
4: event spindle rpm=0 direction="positioned" spindle=2 angle=30 turn=30
5: event spindle rpm=0 direction="oriented" spindle=2
6: event spindle rpm=0 direction="positioned" spindle=2 angle=270 turn=-90
7: event spindle rpm=0 direction="oriented" spindle=2
8: event spindle rpm=0 direction="positioned" spindle=2 angle=18 turn=18
9: event spindle rpm=0 direction="positioned" spindle=2 angle=54 turn=36
10: event spindle rpm=0 direction="positioned" spindle=2 angle=108 turn=54
11: event spindle rpm=0 direction="positioned" spindle=2 angle=108 turn=360
12: event end code="M30"
end of program: 12 blocks, 0 motions, 0 errors, 0 warnings
