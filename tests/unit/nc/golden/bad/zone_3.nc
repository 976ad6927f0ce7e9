=== about
Zone 3: its border belongs to it. A drilling cycle that goes into it stops there.
proves: nct-22.3-zone3
=== settings
N1000.RE3.1 = 1
N1000.RE3.3 = 1
N1008.1 = 50
N1009.1 = 20
N1008.3 = -10
N1009.3 = -30
=== main
G0 X60 Z5
G81 X40 Y7 Z-15 R2 F100
M30
=== truth
60 0 5
40 7 5
40 7 2
40 7 -10
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 60 0 5 t0.24
2: rapid to 40 7 5 t0.08
2: rapid to 40 7 2 t0.012
2: event forbidden_zone zone=3 alarm=3043 message="inner forbidden zone 3"
2: feed to 40 7 -10 F100 t7.2
main.nc:2:1: error[nct-3043]: inner forbidden zone 3
    G81 X40 Y7 Z-15 R2 F100
    ^~~~~~~~~~~~~~~~~~~~~~~
alarm: 2 blocks, 4 motions, 1 errors, 0 warnings
