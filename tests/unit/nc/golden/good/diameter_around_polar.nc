=== about
On a machine with X in diameter the face is programmed in radius: G10.9 X0 before G12.1, G10.9 X1 behind G13.1. The
reading of the position doubles with the diameter, the axis does not move.
proves: nct-5.3.1-G10.9 nct-4.5-G12.1 nct-4.5-G13.1
=== settings
axis = C 4 rotary
N0106.DIA.1 = 1
=== main
G17 G0 X200 C0
#100=#5001
G10.9 X0
#101=#5001
G12.1
G1 X50 F1000
C30
G13.1
G10.9 X1
G1 X100
G0 C0
X#100 Y#101
M30
=== truth
rapid 100 0 0
feed 50 0 0 rotary 0
feed 50 30 0 rotary 30.9638
feed 42.8746 25.7248 0 rotary 30.9638
rapid 50 0 0 rotary 0
rapid 100 100 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 100 0 0 C 0 to 0 t0.4
5: event virtual_plane code="G12.1" on=true axes="X C"
6: feed to 50 0 0 C 0 to 0 F1000 t3
7: feed to 50 30 0 C 0 to 30.9638 F1000 t1.8
8: event virtual_plane code="G12.1" on=false axes="X C"
10: feed to 42.8746 25.7248 0 C 30.9638 to 30.9638 F1000 t0.4986
11: rapid arc to 50 0 0 center 0 0 0 normal 0 0 1 sweep -30.9638 C 30.9638 to 0 t0.1239
12: rapid to 100 100 0 C 0 to 0 t0.4
13: event end code="M30"
end of program: 13 blocks, 6 motions, 0 errors, 0 warnings
