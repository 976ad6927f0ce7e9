=== about
G55 X-910 Y460 is machine (450,900), workpiece (150,100).
proves: nct-3-G92 nct-10.2.6-G92
=== settings
G54 = 300 800 0
G55 = 1300 400 0
=== main
G0 X150 Y100
G92 X90 Y60
X90 Y60
X0 Y0
G55 X-910 Y460
M30
=== truth
150 100 0
60 40 0
150 100 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 150 100 0 t0.6
4: rapid to 60 40 0 t0.36
5: rapid to 150 100 0 t0.36
6: event end code="M30"
end of program: 6 blocks, 3 motions, 0 errors, 0 warnings
