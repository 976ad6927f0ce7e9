=== about
proves: nct-4.3-CCA nct-4.3-IJK
=== settings
N1337.CCA = 1
=== main
G90 G0 X100 Y0 F500
G3 X0 Y100 I0 J0
M30
=== truth
100 0 0
0 100 0 center 0 0 0 sweep 90
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 100 0 0 t0.4
2: feed arc to 0 100 0 center 0 0 0 normal 0 0 1 sweep 90 F500 t18.8496
3: event end code="M30"
end of program: 3 blocks, 2 motions, 0 errors, 0 warnings
