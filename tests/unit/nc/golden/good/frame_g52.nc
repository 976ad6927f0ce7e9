=== about
Blocks that name the present position do not move.
proves: nct-3-G52 nct-10.3-G52
=== main
G0 X150 Y100
G90 G52 X60 Y40
X90 Y60
X0 Y0
G90 G52 X30 Y60
X120 Y40
G91 G52 X30 Y-20
G90 X90 Y60
G90 G52 X0 Y0
X0 Y0
M30
=== truth
150 100 0
60 40 0
150 100 0
0 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 150 100 0 t0.6
4: rapid to 60 40 0 t0.36
6: rapid to 150 100 0 t0.36
10: rapid to 0 0 0 t0.6
11: event end code="M30"
end of program: 11 blocks, 4 motions, 0 errors, 0 warnings
