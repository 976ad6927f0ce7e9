=== settings
N1338 = 1
=== main
M30
=== says
error[nct-parameter]
=== expect
error[nct-parameter]: parameter N1338 of control nct is set by its bits (for example N1338.M06)
alarm: 0 blocks, 0 motions, 1 errors, 0 warnings
