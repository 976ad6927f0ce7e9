=== about
N1006 must be above N1007.
Truth: 22.2; nothing moves.
proves: nct-22.2-param
=== settings
N1000.RE2.1 = 1
N1001.STE = 1
N1006.1 = 5
N1007.1 = 5
=== main
G0 X1
M30
=== says
N1006 must be above N1007
0 motions, 1 errors
=== expect
error[nct-parameter]: zone 2 of axis X: N1006 must be above N1007
alarm: 0 blocks, 0 motions, 1 errors, 0 warnings
