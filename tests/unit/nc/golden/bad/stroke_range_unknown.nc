=== about
Range B of an axis that is not there.
Truth: nothing moves.
proves: nct-22.1-stroke
=== settings
range_b = Q+
=== main
G0 X1
M30
=== says
'Q+'
0 motions, 1 errors
=== expect
error[nct-settings]: range B: 'Q+' is not an axis with + or -
alarm: 0 blocks, 0 motions, 1 errors, 0 warnings
