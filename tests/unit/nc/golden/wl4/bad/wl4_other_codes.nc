=== about
Codes of other controls are refused.
Truth: the table of the G codes has none of these; G21 X3 does not move either.
proves: wl4-5-other
=== settings
control = wl4-mill
max_errors = 9
=== main
%C
G54 G0 X1
G20
G21 X3
G28 X0
G65
G98
M30
%
=== truth
rapid 1 0 0
=== says
main.nc:3:1: error[wl4-code]: G20 is no code
main.nc:4:1: error[wl4-code]: G21 is no code
main.nc:5:1: error[wl4-code]: G28 is no code
main.nc:6:1: error[wl4-code]: G65 is no code
main.nc:7:1: error[wl4-code]: G98 is no code
7 blocks, 1 motions, 5 errors
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 1 0 0 t0.004
main.nc:3:1: error[wl4-code]: G20 is no code of this control
    G20
    ^~~
main.nc:4:1: error[wl4-code]: G21 is no code of this control
    G21 X3
    ^~~
main.nc:5:1: error[wl4-code]: G28 is no code of this control
    G28 X0
    ^~~
main.nc:6:1: error[wl4-code]: G65 is no code of this control
    G65
    ^~~
main.nc:7:1: error[wl4-code]: G98 is no code of this control
    G98
    ^~~
8: event end code="M30"
end of program: 7 blocks, 1 motions, 5 errors, 0 warnings
