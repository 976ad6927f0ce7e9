=== about
M8, the dwell and the Z move happen at the corner, in order.
proves: nct-15.5.2-passthrough nct-15.5-G42
=== settings
D1 = 5
H1 = 0
=== main
G0 X-40 Y0 F100
G42 X0 D1
G1 X60
M8
G4 P1
Z-1
Y60
G40 X-40 M9
M30
=== truth
-40 0 0
0 -5 0
65 -5 0
65 -5 -1
65 65 -1
*  * -1
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -40 0 0 t0.16
main.nc:3:1: warning[nct-cutter-comp]: more blocks without motion in the plane than the control promises to look over
    G1 X60
    ^~~~~~
2: rapid to 0 -5 0 t0.16
3: feed to 65 -5 0 F100 t39
4: event coolant code="M8" on=true
5: event dwell seconds=1
6: feed to 65 -5 -1 F100 t0.6
7: feed to 65 65 -1 F100 t42
8: feed to -40 60 -1 F100 t63.0714
8: event coolant code="M9" on=false
9: event end code="M30"
end of program: 9 blocks, 6 motions, 0 errors, 1 warnings
