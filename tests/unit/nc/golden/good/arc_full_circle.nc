=== about
proves: nct-4.3-full
=== main
G0 X100 Y0 F500
G17 G03 X0 Y100 I-100
G0 X200 Y0 F500
G17 G03 I-100
M30
=== truth
100 0 0
0 100 0 center 0 0 0 sweep 90
200 0 0
200 0 0 center 100 0 0 sweep 360
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 100 0 0 t0.4
2: feed arc to 0 100 0 center 0 0 0 normal 0 0 1 sweep 90 F500 t18.8496
3: rapid to 200 0 0 t0.8
4: feed arc to 200 0 0 center 100 0 0 normal 0 0 1 sweep 360 F500 t75.3982
5: event end code="M30"
end of program: 5 blocks, 4 motions, 0 errors, 0 warnings
