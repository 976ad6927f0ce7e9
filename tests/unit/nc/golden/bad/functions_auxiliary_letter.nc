=== about
Only A, B, C, U, V and W can be auxiliary functions.
proves: nct-13.2-aux
=== settings
N1333 = 68
=== main
M30
=== says
error[nct-parameter]
=== expect
error[nct-parameter]: N1333: auxiliary functions are at A, B, C, U, V or W
alarm: 0 blocks, 0 motions, 1 errors, 0 warnings
