=== about
The channel that is waited for has ended: the others are stopped at once.
proves: nct-14.5-wait nct-1.2-sync
=== settings
N2201 = 500
N2202 = 599
=== main
G1 X10 F600
M501 P12
M30
=== channel 2
M30
=== channel 3
G1 Y50 F6000
Y100
Y250
M30
=== says
main.nc:2:1: error[nct-deadlock]: deadlock of waiting codes: channel 1 waits at main.nc:2 with M501 P12; channel 2 has ended
=== expect
file 0 main.nc
[1] 1: feed from 0 0 0 to 10 0 0 F600 t1
file 1 channel2.nc
[2] 1/1: event end code="M30"
file 2 channel3.nc
[3] 2/1: feed from 0 0 0 to 0 50 0 F6000 t0.5
[3] 2/2: feed to 0 100 0 F6000 t0.5
main.nc:2:1: error[nct-deadlock]: deadlock of waiting codes: channel 1 waits at main.nc:2 with M501 P12; channel 2 has ended; channel 3 is at channel3.nc:2
    M501 P12
    ^~~~~~~~
    note: in channel 1
cycle 1 s
alarm: 5 blocks, 3 motions, 1 errors, 0 warnings
