=== about
Two axes of one number.
=== settings
axis = C 3 rotary
=== main
G0 X1
M30
=== says
error[nct-settings]
=== expect
error[nct-settings]: axes Z and C have one number
alarm: 0 blocks, 0 motions, 1 errors, 0 warnings
