=== about
The direction is turned and mirrored.
proves: nct-15.5.6-G39
=== settings
D1 = 5
=== main
G17 G90 G0 X50 Y0
G51.1 X0
G68 X0 Y0 R90
G41 G1 X0 Y0 D1 F100
N110 G91 X100
N120 G39 I50 J-60
N130 G40 X110 Y30
M30
=== truth
50 0 0
5 0 0
5 100 0
3.2009 103.8411 0 center 0 100 0
30 210 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 50 0 0 t0.2
4: feed to 5 0 0 F100 t27
5 N110: feed to 5 100 0 F100 t60
6 N120: feed arc to 3.2009 103.8411 0 center 0 100 0 normal 0 0 1 sweep 50.1944 F100 t2.6282
7 N130: feed to 30 210 0 F100 t65.6936
8: event end code="M30"
end of program: 8 blocks, 5 motions, 0 errors, 0 warnings
