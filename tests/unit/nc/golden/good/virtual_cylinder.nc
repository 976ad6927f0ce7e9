=== about
Lines on a cylinder about X of 28.65 mm: 1 deg is 0.5000368 mm; the feed counts on the surface. The tool stands still
along Z, the part turns: a helix about X in the part, the tool's direction turns with it.
proves: nct-4.6-G7.1 nct-4.6-plane nct-2.4-units
=== settings
axis = A 4 rotary
=== main
G0 Y0 Z60
G18 X-20 A0
G1 Z25.65 F500
G7.1 A28.65
G1 X-10 F500
A30
X-40 A90
G91 A-45
G90 A0
G7.1 A0
G0 Z100
M30
=== truth
rapid 0 0 60
rapid -20 0 60
feed -20 0 25.65
feed -10 0 25.65 t 1.2 rotary 0
feed -10 -12.825 22.2136 center -10 0 0 sweep 30 t 1.8001 rotary 30
feed -40 -25.65 0 center -10 0 0 sweep 60 t 5.0914 rotary 90
feed -40 -18.1373 18.1373 sweep -45 rotary 45
feed -40 0 25.65 rotary 0
rapid -40 0 100
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 60 A 0 to 0 t0.24
2: rapid to -20 0 60 A 0 to 0 t0.08
3: feed to -20 0 25.65 A 0 to 0 F500 t4.122
4: event virtual_plane code="G7.1" on=true axes="X A" radius=28.65
5: feed to -10 0 25.65 A 0 to 0 F500 t1.2
6: feed arc to -10 -12.825 22.2136 center -10 0 0 normal 1 0 0 sweep 30 axis 0 0 1 to 0 -0.5 0.866 A 0 to 30 F447.644 t1.8001
7: feed arc to -40 -25.65 0 center -10 0 0 normal 1 0 0 sweep 60 axis 0 -0.5 0.866 to 0 -1 0 A 30 to 90 F474.5427 t5.0914
8: feed arc to -40 -18.1373 18.1373 center -40 0 0 normal 1 0 0 sweep -45 axis 0 -1 0 to 0 -0.7071 0.7071 A 90 to 45 F447.644 t2.7002
9: feed arc to -40 0 25.65 center -40 0 0 normal 1 0 0 sweep -45 axis 0 -0.7071 0.7071 to 0 0 1 A 45 to 0 F447.644 t2.7002
10: event virtual_plane code="G7.1" on=false axes="X A"
11: rapid to -40 0 100 A 0 to 0 t0.2974
12: event end code="M30"
end of program: 12 blocks, 9 motions, 0 errors, 0 warnings
