=== about
Arcs that are none.
Truth: a chord of 100 is longer than 2 R; (10, 0) is 6 from the centre (4, 0) of radius 4; 10 and 5 are no quarter;
nothing moves.
proves: wl4-5.1.3-R wl4-5.1.4-G12
=== settings
control = wl4-mill
max_errors = 9
=== main
%A
G54 G0 X0 Y0
G2 X100 R10 F100
G0 X0 Y0
G2 X10 Y0 I4
G12 X10 Y5
G3 X5
G2 X5 Y5 K3 I2
M30
%
=== says
main.nc:3:9: error[wl4-arc]: the end is 100.000 mm away: R10
main.nc:5:1: error[wl4-arc]: the end is off the circle by 2.0000 mm
main.nc:6:1: error[wl4-corner-arc]: G12 and G13 are quarter circles: the way is 10.000 and 5.000 mm
main.nc:7:1: error[wl4-arc]
main.nc:8:1: error[wl4-arc]
8 blocks, 0 motions, 5 errors
=== expect
file 0 main.nc
main.nc:3:9: error[wl4-arc]: the end is 100.000 mm away: R10 does not reach it
    G2 X100 R10 F100
            ^~~
main.nc:5:1: error[wl4-arc]: the end is off the circle by 2.0000 mm
    G2 X10 Y0 I4
    ^~~~~~~~~~~~
main.nc:6:1: error[wl4-corner-arc]: G12 and G13 are quarter circles: the way is 10.000 and 5.000 mm
    G12 X10 Y5
    ^~~~~~~~~~
main.nc:7:1: error[wl4-arc]: an arc needs its centre (two of I J K) or R
    G3 X5
    ^~~~~
main.nc:8:1: error[wl4-arc]: the centre is given outside the plane of G17, G18 or G19
    G2 X5 Y5 K3 I2
    ^~~~~~~~~~~~~~
9: event end code="M30"
end of program: 8 blocks, 0 motions, 5 errors, 0 warnings
