=== about
In G12.1 and G7.1 the variables of program coordinates tell the programmed plane, those of machine coordinates the axes. (10,10) of the face is
radius 14.1421 at 45 degrees. On the cylinder of radius 50 the table's position is in degrees.
proves: nct-23.1.15-absio nct-23.1.15-absmt nct-23.1.15-absot
=== settings
axis = C 4 rotary
=== main
G17 G0 X10 C0
G12.1
G1 C10 F600
#101=#5001
#102=#5004
#103=#5021
#104=#5024
#105=#5041
#106=#5044
X20 C0
G13.1
G0 X#101 Y#102 Z#103
X#104 Y#105 Z#106
G18 Z-20 C0
G7.1 C50
G1 C30
#101=#5004
#102=#5024
#103=#5044
C0
G7.1 C0
G0 X#101 Y#102 Z#103
M30
=== truth
10 0 0
10 10 0 rotary 45
20 0 0 rotary 0
10 10 14.1421
45 10 10
45 10 -20
* * -20 rotary 30
45 10 -20 rotary 0
30 30 30
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 10 0 0 C 0 to 0 t0.04
2: event virtual_plane code="G12.1" on=true axes="X C"
3: feed to 10 10 0 C 0 to 45 F600 t1
10: feed to 20 0 0 C 45 to 0 F600 t1.4142
11: event virtual_plane code="G12.1" on=false axes="X C"
12: rapid to 10 10 14.1421 C 0 to 0 t0.0566
13: rapid to 45 10 10 C 0 to 0 t0.14
14: rapid to 45 10 -20 C 0 to 0 t0.12
15: event virtual_plane code="G7.1" on=true axes="Z C" radius=50
16: feed arc to 33.9711 31.1603 -20 center 0 0 -20 normal 0 0 1 sweep 30 C 0 to 30 F553.1727 t2.618
20: feed arc to 45 10 -20 center 0 0 -20 normal 0 0 1 sweep -30 C 30 to 0 F553.1727 t2.618
21: event virtual_plane code="G7.1" on=false axes="Z C"
22: rapid to 30 30 30 C 0 to 0 t0.2
23: event end code="M30"
end of program: 23 blocks, 9 motions, 0 errors, 0 warnings
