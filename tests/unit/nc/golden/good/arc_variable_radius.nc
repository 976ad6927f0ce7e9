=== about
proves: nct-4.3-N1339 nct-4.3-vararc
=== settings
N1339 = 30
=== main
G17 G90 G0 X50 Y0 F500
G3 X-20 I-50
M30
=== truth
50 0 0
-20 0 0 center 0 0 0 sweep 180 at 0.5 0 35 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 50 0 0 t0.2
2: feed arc to -20 0 0 center 0 0 0 normal 0 0 1 sweep 180 F363.5841 t18.8496
3: event end code="M30"
end of program: 3 blocks, 2 motions, 0 errors, 0 warnings
