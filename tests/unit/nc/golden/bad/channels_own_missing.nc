=== about
P has to name the own channel.
proves: nct-14.5-wait
=== settings
N2201 = 500
N2202 = 599
=== main
M501 P12
M30
=== channel 2
N5 M501 P13
M30
=== channel 3
M30
=== says
channel2.nc:1:9: error[nct-wait]
note: in channel 2
=== expect
file 0 main.nc
file 1 channel2.nc
channel2.nc:1:9: error[nct-wait]: M501 P13 in channel 2: P has to name the own channel too
    N5 M501 P13
            ^~~
    note: in channel 2
file 2 channel3.nc
cycle 0 s
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings
