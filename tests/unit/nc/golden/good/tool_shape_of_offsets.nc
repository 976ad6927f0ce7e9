=== about
D of a row with a corner radius (geometry and wear) tells the shape of the tool in the spindle: bull, ball and flat ends. A row without one tells
nothing.
proves: nct-15.1-cornerradius
=== main
G10 L12 P1 R5
G10 L110 P1 R2
G10 L111 P1 R-0.5
G10 L12 P2 R4
G10 L110 P2 R4
G10 L12 P3 R6
T1 M6
G0 G41 X0 Y20 D1
X10
G40 X20
T2 D2 M6
D3
M30
=== truth
* * * T 1
* * * T 1
* * * T 1
=== expect
file 0 main.nc
7: event tool tool=1
8: rapid from 0 0 0 to -5 25 0 t0.1
8: event tool_shape tool=1 d=1 diameter=10 corner_radius=1.5
9: rapid to 10 25 0 t0.06
10: rapid to 20 20 0 t0.04
11: event tool tool=2
11: event tool_shape tool=2 d=2 diameter=8 corner_radius=4
13: event end code="M30"
end of program: 13 blocks, 3 motions, 0 errors, 0 warnings
