=== settings
N1338 = 1
=== main
M30
=== expect
error[nct-parameter]: unknown parameter N1338 of control nct (nearest known: N1339)
alarm: 0 blocks, 0 motions, 1 errors, 0 warnings
