=== about
With N1755.TLC positions with offsets are read without the length; G52 and G92 move the coordinates that are read; the
machine position stays what it is.
proves: nct-23.1.15-absot nct-23.1.15-absio
=== settings
G54 = 0 0 20
H1 = 100
N1755.TLC = 1
=== main
G43 G0 X3 Y4 Z-5 H1
#102=#5043
G52 X1
#103=#5001
G52 X0
G92 Y0
#104=#5002
#105=#5022
G53 X#102 Y#103 Z#104
G53 Y#105
M30
=== truth
3 4 95
-5 2 -20
-5 4 -20
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 3 4 95 t0.38
main.nc:9:1: warning[nct-machine-zero]: G53: the job gives no reference point ([machine] reference_points), so machine zero is only as good as its work offsets ([offsets.work])
    G53 X#102 Y#103 Z#104
    ^~~~~~~~~~~~~~~~~~~~~
9: rapid to -5 2 -20 t0.46
10: rapid to -5 4 -20 t0.008
11: event end code="M30"
end of program: 11 blocks, 3 motions, 0 errors, 1 warnings
