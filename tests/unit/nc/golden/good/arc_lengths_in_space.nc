=== about
N1337.HEF: the feed counts along the path in space. Helix of four turns: 1256.7962 mm; cone: 880.4354 mm.
proves: nct-4.3.2-HEF nct-4.3.3-cone
=== settings
N1337.HEF = 1
=== main
G17 G90 G0 X-50 Y0
Z0
G2 I50 Z-20 L4 F100
G0 Z0
G2 X-20 I50 Z-20 L4 F100
M30
=== truth
-50 0 0
-50 0 -20 center 0 0 0 sweep -1440 t 754.0777
-50 0 0
-20 0 -20 center 0 0 0 sweep -1440 t 528.2612 at 0.25 -42.5 0 -5 at 0.5 -35 0 -10 at 0.75 -27.5 0 -15
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -50 0 0 t0.2
3: feed arc to -50 0 -20 center 0 0 0 normal 0 0 1 sweep -1440 F100 t754.0777
4: rapid to -50 0 0 t0.08
5: feed arc to -20 0 -20 center 0 0 0 normal 0 0 1 sweep -1440 F100 t528.2612
6: event end code="M30"
end of program: 6 blocks, 4 motions, 0 errors, 0 warnings
