=== about
G5.1: the axes are only named, nothing moves; the path stays the polyline and the event tells how far the machine's may
be from it.
proves: nct-4.7-G5.1Q0 nct-4.7-G5.1Q1 nct-4.7-G5.1Q2 nct-4.7.1-G5.1Q3 nct-4.7-N3100 nct-4.7-N3101 nct-4.7-N3102 nct-4.7-N3103
nct-4.7-N3104 nct-4.7-N3105 nct-4.7.1-N3106 nct-4.7.1-N3107
=== settings
N3100 = 5
N3101 = 0.02
N3102 = 30
N3103 = 0.01
N3104 = 0.05
N3105 = 0.002
N3106 = 0.03
N3107 = 0.04
=== main
G43 H0 X0 Y0 Z5
G5.1 Q2 X0 Z0
G1 X1 Z4 F100
X2 Z3.5
G5.1 Q3 X0 Y0 Z0
X3 Z3
G5.1 Q1
G5.1 Q3
G5.1 Q0
G49
M30
=== truth
rapid 0 0 5
feed 1 0 4
feed 2 0 3.5
feed 3 0 3
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 5 t0.02
2: event smoothing mode=2 axes="X Z" tolerance=0.06 longest=5 shortest=0.02 angle=30 joined=0.01 least=0.002
3: feed to 1 0 4 F100 t0.8485
4: feed to 2 0 3.5 F100 t0.6708
5: event smoothing mode=3 axes="X Y Z" tolerance=0.04 longest=5 shortest=0.02 angle=30 joined=0.01 any_angle_below=0.04
6: feed to 3 0 3 F100 t0.6708
7: event smoothing mode=1
8: event smoothing mode=3 axes="X Y Z" tolerance=0.04 longest=5 shortest=0.02 angle=30 joined=0.01 any_angle_below=0.04
9: event smoothing mode=0
11: event end code="M30"
end of program: 11 blocks, 4 motions, 0 errors, 0 warnings
