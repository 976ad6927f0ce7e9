=== about
X beyond 100; the arc beyond Y-80 although both its ends are inside.
=== settings
limit_X = -100 100
limit_Y = -80 80
=== main
G0 X50
X101
G1 X90 Y0 F100
G2 X-90 I-90
M30
=== truth
50 0 0
101 0 0
90 0 0
-90 0 0 center 0 0 0 sweep -180
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 50 0 0 t0.2
2: event overtravel axis="X" value=101 limit=100
2: rapid to 101 0 0 t0.204
3: event overtravel axis="X" value=101 limit=100
3: feed to 90 0 0 F100 t6.6
4: event overtravel axis="Y" value=-90 limit=-80
4: feed arc to -90 0 0 center 0 0 0 normal 0 0 1 sweep -180 F100 t169.646
5: event end code="M30"
end of program: 5 blocks, 4 motions, 0 errors, 0 warnings
