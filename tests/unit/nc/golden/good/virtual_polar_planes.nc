=== about
The letters of centres in G18 (K for the linear axis, I for the virtual one) and G19 (J, K), a linear axis on the negative
side, polar data in the virtual plane.
proves: nct-4.5-arc nct-4.5-plane
=== settings
axis = C 4 rotary
axis = B 5 rotary
=== main
G19 G0 Y40 C0
G12.1
G1 Y20 F100
G3 Y0 C20 J-20 K0
G13.1
G0 C0
Y0
G17 G0 X-40 C0
G12.1
G16 G1 X20 C90
G15
G13.1
G0 C0
X0
G18 Z30 B0
G12.1
G2 Z0 B-30 K-30 I0
G13.1
M30
=== truth
rapid 0 40 0
feed 0 20 0
feed -20 0 0 center 0 0 0 sweep 90 rotary 90 0
rapid 0 20 0
rapid 0 0 0
rapid -40 0 0
feed 0 20 0 rotary -90 0
rapid -20 0 0
rapid 0 0 0
rapid 0 0 30
feed -30 0 0 center 0 0 0 sweep -90 rotary 0 -90
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 40 0 C 0 to 0 B 0 to 0 t0.16
2: event virtual_plane code="G12.1" on=true axes="Y C"
3: feed to 0 20 0 C 0 to 0 B 0 to 0 F100 t12
4: feed arc to -20 0 0 center 0 0 0 normal 0 0 1 sweep 90 C 0 to 90 B 0 to 0 F100 t18.8496
5: event virtual_plane code="G12.1" on=false axes="Y C"
6: rapid arc to 0 20 0 center 0 0 0 normal 0 0 1 sweep -90 C 90 to 0 B 0 to 0 t0.36
7: rapid to 0 0 0 C 0 to 0 B 0 to 0 t0.08
8: rapid to -40 0 0 C 0 to 0 B 0 to 0 t0.16
9: event virtual_plane code="G12.1" on=true axes="X C"
10: feed to 0 20 0 C 0 to -90 B 0 to 0 F100 t26.8328
12: event virtual_plane code="G12.1" on=false axes="X C"
13: rapid arc to -20 0 0 center 0 0 0 normal 0 0 1 sweep 90 C -90 to 0 B 0 to 0 t0.36
14: rapid to 0 0 0 C 0 to 0 B 0 to 0 t0.08
15: rapid to 0 0 30 C 0 to 0 B 0 to 0 t0.12
16: event virtual_plane code="G12.1" on=true axes="Z B"
17: feed arc to -30 0 0 center 0 0 0 normal 0 1 0 sweep -90 axis 0 0 1 to -1 0 0 C 0 to 0 B 0 to -90 F100 t28.2743
18: event virtual_plane code="G12.1" on=false axes="Z B"
19: event end code="M30"
end of program: 19 blocks, 11 motions, 0 errors, 0 warnings
