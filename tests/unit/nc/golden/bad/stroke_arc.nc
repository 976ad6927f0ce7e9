=== about
The arc of radius 90 about 0 0 leaves Y-80.
proves: nct-22.1-stroke
=== settings
N1002.2 = 80
N1003.2 = -80
=== main
G0 X90
G2 X-90 I-90 F1000
M30
=== truth
90 0 0
41.2311 -80 0 center 0 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 90 0 0 t0.36
2: event overtravel axis="Y" value=-80 limit=-80 alarm=3011
2: feed arc to 41.2311 -80 0 center 0 0 0 normal 0 0 1 sweep -62.734 F1000 t5.9125
main.nc:2:1: error[nct-3011]: ran onto negative end position on axis Y
    G2 X-90 I-90 F1000
    ^~~~~~~~~~~~~~~~~~
alarm: 2 blocks, 2 motions, 1 errors, 0 warnings
