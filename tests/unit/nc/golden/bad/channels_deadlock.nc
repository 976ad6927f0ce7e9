=== about
Two channels wait for each other at different points; the third has nothing to do with it and runs to its end.
proves: nct-14.5-wait
=== settings
N2201 = 500
N2202 = 599
=== main
N10 G1 X100 F6000
N60 M501 P12
N70 M502 P12
M30
=== channel 2
N20 M502 P12
N30 M501 P12
M30
=== channel 3
G1 Y500 F6000
M30
=== says
[3] 2/1: feed from 0 0 0 to 0 500 0
main.nc:2:1: error[nct-deadlock]: deadlock of waiting codes: channel 1 waits at main.nc:2 N60 with M501 P12; channel 2 waits at channel2.nc:1 N20 with M502 P12
=== expect
file 0 main.nc
[1] 1 N10: feed from 0 0 0 to 100 0 0 F6000 t1
file 1 channel2.nc
file 2 channel3.nc
[3] 2/1: feed from 0 0 0 to 0 500 0 F6000 t5
main.nc:2:1: error[nct-deadlock]: deadlock of waiting codes: channel 1 waits at main.nc:2 N60 with M501 P12; channel 2 waits at channel2.nc:1 N20 with M502 P12; channel 3 has ended
    N60 M501 P12
    ^~~~~~~~~~~~
    note: in channel 1
cycle 1 s
alarm: 5 blocks, 2 motions, 1 errors, 0 warnings
