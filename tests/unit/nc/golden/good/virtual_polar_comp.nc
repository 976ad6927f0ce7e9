=== about
Cutter compensation in the virtual plane: a square of 40 about the centre, tool outside to the right at 5 mm.
proves: nct-4.5-N0217 nct-4.5-comp nct-4.5-G12.1
=== settings
axis = C 4 rotary
D1 = 5
N0217.4 = 0.01
=== main
G17 G0 X60 C0
G12.1
G1 G42 D1 X20 F500
C20
X-20
C-20
X20
C0
G40 X60
G13.1
M30
=== truth
rapid 60 0 0
feed 25 0 0
feed 25 25 0
feed -25 25 0
feed -25 -25 0
feed 25 -25 0
feed 25 0 0
feed 60 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 60 0 0 C 0 to 0 t0.24
2: event virtual_plane code="G12.1" on=true axes="X C" offset=0.01
3: feed to 25 0 0 C 0 to 0 F500 t4.2
4: feed to 25 25 0 C 0 to 45 F500 t3
5: feed to -25 25 0 C 45 to 135 F500 t6
6: feed to -25 -25 0 C 135 to 225 F500 t6
7: feed to 25 -25 0 C 225 to 315 F500 t6
8: feed to 25 0 0 C 315 to 360 F500 t3
9: feed to 60 0 0 C 360 to 360 F500 t4.2
10: event virtual_plane code="G12.1" on=false axes="X C"
11: event end code="M30"
end of program: 11 blocks, 8 motions, 0 errors, 0 warnings
