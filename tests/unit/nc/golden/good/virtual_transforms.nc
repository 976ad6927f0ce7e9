=== about
Rotation, scaling and mirroring in the plane of G12.1: contours turn in the part. A quarter circle keeps its centre's place in the figure and
turns the other way where the figure is mirrored.
proves: nct-16.1-G68 nct-16.2-G51-P nct-16.3-G51.1 nct-16.4-order
=== settings
axis = C 4 rotary
=== main
G17 G0 X100 C0
G12.1
G1 X60 F1000
G68 X0 C0 R90
X50 C10
C30
G69
G51.1 C0
X50 C10
G3 X40 C20 I-10
G50.1 C0
G51 X10 C0 P0.5
G1 X50 C10
G68 X10 C0 R-90
X50 C10
G69
G50
X60 C0
G13.1
M30
=== truth
rapid 100 0 0
feed 60 0 0
feed -10 50 0
feed -30 50 0
feed 50 -10 0
feed 40 -20 0 center 40 -10 0 sweep -90
feed 30 5 0
feed 15 -20 0
feed 60 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 100 0 0 C 0 to 0 t0.4
2: event virtual_plane code="G12.1" on=true axes="X C"
3: feed to 60 0 0 C 0 to 0 F1000 t2.4
5: feed to -10 50 0 C 0 to 101.3099 F1000 t5.1614
6: feed to -30 50 0 C 101.3099 to 120.9638 F1000 t1.2
9: feed to 50 -10 0 C 120.9638 to -11.3099 F1000 t6
10: feed arc to 40 -20 0 center 40 -10 0 normal 0 0 1 sweep -90 C -11.3099 to -26.5651 F1000 t0.9425
13: feed to 30 5 0 C -26.5651 to 9.4623 F1000 t1.6155
15: feed to 15 -20 0 C 9.4623 to -53.1301 F1000 t1.7493
18: feed to 60 0 0 C -53.1301 to 0 F1000 t2.9547
19: event virtual_plane code="G12.1" on=false axes="X C"
20: event end code="M30"
end of program: 20 blocks, 9 motions, 0 errors, 0 warnings
