=== about
A line through the centre of the face: the path in the part is straight, the rotary axis turns by half a turn there (3 s). Near the
centre the highest feed of the rotary axis (N0305) holds the tool back: 90 degrees at 3600 deg/min.
proves: nct-4.5-feed nct-4.5-N0305
=== settings
axis = C 4 rotary
N0305.4 = 3600
=== main
G17 G0 X10 C0
G12.1
G1 X0.1 F600
C10
C-10
X10
X-10 C10
G13.1
M30
=== truth
rapid 10 0 0
feed 0.1 0 0
feed 0.1 10 0 t 2.3049
feed 0.1 -10 0 t 4.6098
feed 10 -10 0 F 600
feed -10 10 0 t 5.8284 rotary 135
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 10 0 0 C 0 to 0 t0.04
2: event virtual_plane code="G12.1" on=true axes="X C"
3: feed to 0.1 0 0 C 0 to 0 F600 t0.99
4: feed to 0.1 10 0 C 0 to 89.4271 F260.3149 t2.3049
5: feed to 0.1 -10 0 C 89.4271 to -89.4271 F260.3149 t4.6098
6: feed to 10 -10 0 C -89.4271 to -45 F600 t0.99
7: feed to -10 10 0 C -45 to 135 F291.1688 t5.8284
8: event virtual_plane code="G12.1" on=false axes="X C"
9: event end code="M30"
end of program: 9 blocks, 6 motions, 0 errors, 0 warnings
