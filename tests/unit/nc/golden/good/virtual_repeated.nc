=== about
G12.1 when it is on has no effect, with a warning; G13.1 when it is off none. The rotary axis counts like a linear one in G7.1: from 0 to
360 it makes a whole turn although it rolls over.
proves: nct-4.5-G12.1 nct-4.5-G13.1 nct-4.6-G7.1
=== settings
axis = C 4 rotary
axis = A 5 rotary
N0107.REN.5 = 1
=== main
G13.1
G17 G0 X10 C0
G12.1
G12.1
G13.1
G13.1
G18 G0 X0 A0
Z20
G7.1 A20
G1 A360 F1000
G7.1 A0
M30
=== truth
10 0 0
0 0 0
0 0 20
0 -20 0 center 0 0 0 sweep 90
0 0 -20 center 0 0 0 sweep 90
0 20 0 center 0 0 0 sweep 90
0 0 20 center 0 0 0 sweep 90 rotary 0 360
=== says
warning[nct-virtual-on]
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 10 0 0 C 0 to 0 A 0 to 0 t0.04
3: event virtual_plane code="G12.1" on=true axes="X C"
main.nc:4:1: warning[nct-virtual-on]: G12.1 is on already: no effect
    G12.1
    ^~~~~
5: event virtual_plane code="G12.1" on=false axes="X C"
7: rapid to 0 0 0 C 0 to 0 A 0 to 0 t0.04
8: rapid to 0 0 20 C 0 to 0 A 0 to 0 t0.08
9: event virtual_plane code="G7.1" on=true axes="X A" radius=20
10: feed arc to 0 -20 0 center 0 0 0 normal 1 0 0 sweep 90 axis 0 0 1 to 0 -1 0 C 0 to 0 A 0 to 90 F1000 t1.885
10: feed arc to 0 0 -20 center 0 0 0 normal 1 0 0 sweep 90 axis 0 -1 0 to 0 0 -1 C 0 to 0 A 90 to 180 F1000 t1.885
10: feed arc to 0 20 0 center 0 0 0 normal 1 0 0 sweep 90 axis 0 0 -1 to 0 1 0 C 0 to 0 A 180 to 270 F1000 t1.885
10: feed arc to 0 0 20 center 0 0 0 normal 1 0 0 sweep 90 axis 0 1 0 to 0 0 1 C 0 to 0 A 270 to 360 F1000 t1.885
11: event virtual_plane code="G7.1" on=false axes="X A"
12: event end code="M30"
end of program: 12 blocks, 7 motions, 0 errors, 1 warnings
