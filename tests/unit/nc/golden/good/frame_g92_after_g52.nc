=== about
G92 deletes the G52 shift of the axes that it names, no other.
proves: nct-10.2.6-G92
=== main
G0 X200 Y120
G52 X60 Y40
X140 Y80
G92 X110
X110 Y80
X0 Y0
M30
=== truth
200 120 0
90 40 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 200 120 0 t0.8
6: rapid to 90 40 0 t0.44
7: event end code="M30"
end of program: 7 blocks, 2 motions, 0 errors, 0 warnings
