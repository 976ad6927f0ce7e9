=== about
More than 100 waiting codes.
=== settings
N2201 = 500
N2202 = 600
=== main
M30
=== says
error[nct-parameter]: N2201, N2202
=== expect
error[nct-parameter]: N2201, N2202: first and last waiting code, at most 100 codes
alarm: 0 blocks, 0 motions, 1 errors, 0 warnings
