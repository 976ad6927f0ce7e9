=== about
Without Y the centre is at the Y of the moment.
proves: nct-16.1-G68
=== main
G17 G90 G0 X20 Y10
G68 X5 R90
G0 X5 Y20
G69
M30
=== truth
20 10 0
-5 10 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 20 10 0 t0.08
3: rapid to -5 10 0 t0.1
5: event end code="M30"
end of program: 5 blocks, 2 motions, 0 errors, 0 warnings
