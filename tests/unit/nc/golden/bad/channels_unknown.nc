=== about
P names a channel that is not there.
=== settings
N2201 = 500
N2202 = 599
=== main
M501 P14
M30
=== channel 2
M30
=== says
main.nc:1:6: error[nct-wait]: M501 P14: the run has no channel 4
=== expect
file 0 main.nc
main.nc:1:6: error[nct-wait]: M501 P14: the run has no channel 4
    M501 P14
         ^~~
    note: in channel 1
file 1 channel2.nc
cycle 0 s
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
