=== settings
N1747 = 78
N1751 = 11
=== main
G0 X6
M30
=== says
error[nct-parameter]
=== expect
error[nct-parameter]: N1747: 78 is the code of no letter that may call (A to Z without G, M, N, O)
alarm: 0 blocks, 0 motions, 1 errors, 0 warnings
