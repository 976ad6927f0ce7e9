=== about
RI adds to the angle in force, and so does R in G91, where the centre is incremental too: here it is
where the tool stands, so that the tool does not move and Y10 then goes to -X.
proves: nct-16.1-G68
=== main
G17 G90 G0 X10 Y0
G68 X0 Y0 R30
G68 X0 Y0 RI15
G0 X10 Y0
G91 G68 X0 Y0 R45
X0 Y10
G90 G69 G1 X0 Y0 F100
M30
=== truth
10 0 0
7.0711 7.0711 0
-2.9289 7.0711 0
0 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 10 0 0 t0.04
4: rapid to 7.0711 7.0711 0 t0.0283
6: rapid to -2.9289 7.0711 0 t0.04
7: feed to 0 0 0 F100 t4.5922
8: event end code="M30"
end of program: 8 blocks, 4 motions, 0 errors, 0 warnings
