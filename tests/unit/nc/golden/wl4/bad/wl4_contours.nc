=== about
Contours and cycles that are refused.
Truth: the block that 10 (P Q, I K, R, E, forbidden codes) forbids; 20 mm by 0.001 are 20000 passes. X60 is a
diameter.
proves: wl4-11.9.1-G77 wl4-4.2-Q
=== settings
control = wl4-lathe
max_errors = 20
=== main
%G77
G54 G94 F100
G0 X60 Z2
G77 G0 X20 Z0 P10 Q99 E5
G77 X20 Z0 P10 Q11 E5
G77 G0 X20 Z0 P10 Q11 R1 E5
G77 G0 G41 X20 Z0 P10 Q11 R1 I1 E5
G77 G0 X20 Z0 P10 Q12 E5
G76 G0 X20 Z0 P10 Q11 E5
G77 G0 X20 Z0 P10 Q11 E0.001
M2
N10 G1 Z-10
N11 X40
N12 G4 E1
%
=== truth
rapid 30 0 2
=== says
main.nc:4:1: error
main.nc:5:1: error
main.nc:6:1: error
main.nc:7:1: error
main.nc:14:5: error
main.nc:9:1: error
main.nc:10:1: error
10 blocks, 1 motions, 7 errors
=== expect
file 0 main.nc
3: rapid from 0 0 0 to 30 0 2 t0.12
main.nc:4:1: error[wl4-contour]: there is no block N10 followed by N99
    G77 G0 X20 Z0 P10 Q99 E5
    ^~~~~~~~~~~~~~~~~~~~~~~~
main.nc:5:1: error[wl4-contour]: G0 or G1 is missing: it says how the tool goes to its passes
    G77 X20 Z0 P10 Q11 E5
    ^~~~~~~~~~~~~~~~~~~~~
main.nc:6:1: error[wl4-contour]: the allowance R needs G41 or G42
    G77 G0 X20 Z0 P10 Q11 R1 E5
    ^~~~~~~~~~~~~~~~~~~~~~~~~~~
main.nc:7:1: error[wl4-contour]: allowances are either I and K or R
    G77 G0 G41 X20 Z0 P10 Q11 R1 I1 E5
    ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
main.nc:14:5: error[wl4-contour-code]: forbidden code G4 in a contour
    N12 G4 E1
        ^~
main.nc:9:1: error[wl4-contour]: G76 needs the stock U, W or C together with E
    G76 G0 X20 Z0 P10 Q11 E5
    ^~~~~~~~~~~~~~~~~~~~~~~~
main.nc:10:1: error[wl4-contour]: E0.001 makes more than 5000 passes
    G77 G0 X20 Z0 P10 Q11 E0.001
    ^~~~~~~~~~~~~~~~~~~~~~~~~~~~
11: event end code="M2"
end of program: 10 blocks, 1 motions, 7 errors, 0 warnings
