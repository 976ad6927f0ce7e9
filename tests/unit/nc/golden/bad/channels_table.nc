=== about
A table that turns the part would turn it for both channels.
=== settings
axis = C 4 rotary
=== main
M30
=== channel 2
M30
=== says
error[nct-channel]: axis C turns the part
=== expect
error[nct-channel]: axis C turns the part: with several channels it would turn it for all of them, which is not supported (carries = "nothing" only tells its position)
file 0 main.nc
file 1 channel2.nc
cycle 0 s
alarm: 0 blocks, 0 motions, 1 errors, 0 warnings
