=== about
A parameter of the whole control cannot differ.
proves: nct-1.2-channel
=== main
M30
=== channel 2 N1700 = 5
M30
=== says
error[nct-channel]: parameter N1700 belongs to the whole control
=== expect
error[nct-channel]: parameter N1700 belongs to the whole control, channel 2 cannot have its own
cycle 0 s
alarm: 0 blocks, 0 motions, 1 errors, 0 warnings
