=== settings
N1339 = -1
=== main
M30
=== says
error[nct-parameter]
=== expect
error[nct-parameter]: parameter N1339 = -1: must be from 0 to 1000
alarm: 0 blocks, 0 motions, 1 errors, 0 warnings
