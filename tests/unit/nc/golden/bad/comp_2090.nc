=== about
proves: nct-15.5.2-2090
=== settings
D1 = 2
=== main
G0 X-50 F100
G41 X-20 D1
G1 X0
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
M8
M9
X50
G40 X80
M30
=== says
error[nct-2090]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -50 0 0 t0.2
main.nc:3:1: warning[nct-cutter-comp]: more blocks without motion in the plane than the control promises to look over
    G1 X0
    ^~~~~
main.nc:3:1: error[nct-2090]: cutter compensation cannot be continued, buffer full: too many blocks without motion in the plane
    G1 X0
    ^~~~~
alarm: 104 blocks, 1 motions, 1 errors, 1 warnings
