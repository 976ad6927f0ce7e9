=== about
G52 in steps, and G92 behind it: the local shift goes, G92 counts from the work zero: (90,80). Blocks that name the present
position do not move.
proves: nct-10.3-G52 nct-10.2.6-G92
=== main
G0 X150 Y100
G90 G52 X60 Y40
X90 Y60
G91 G52 X-30 Y20
G90 X120 Y40
G52 X0 Y0
X200 Y120
G52 X60 Y40
X140 Y80
G92 X110 Y40
X110 Y40
X0 Y0
M30
=== truth
150 100 0
200 120 0
90 80 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 150 100 0 t0.6
7: rapid to 200 120 0 t0.2
12: rapid to 90 80 0 t0.44
13: event end code="M30"
end of program: 13 blocks, 3 motions, 0 errors, 0 warnings
