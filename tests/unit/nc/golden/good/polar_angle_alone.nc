=== about
A polar step of the angle alone keeps the radius about the origin; the angle counts from where the tool stands.
proves: nct-5.4-G16
=== main
G0 X10 Y0
G16 G91 Y30
Y60
G90 Y180
G15
M30
=== truth
10 0 0
8.6603 5 0
0 10 0
-10 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 10 0 0 t0.04
2: rapid to 8.6603 5 0 t0.02
3: rapid to 0 10 0 t0.0346
4: rapid to -10 0 0 t0.04
6: event end code="M30"
end of program: 6 blocks, 4 motions, 0 errors, 0 warnings
