=== about
An address cannot be an axis and an auxiliary function.
proves: nct-13.2-aux
=== settings
N1335 = 66
axis = B 5 rotary
=== main
M30
=== says
error[nct-parameter]
=== expect
error[nct-parameter]: N1335: B is an axis and cannot be an auxiliary function
alarm: 0 blocks, 0 motions, 1 errors, 0 warnings
