=== about
Angles beyond a turn about the arc's centre: helix of 2 3/4 turns clockwise; with I and J; an angle against the
sense of the arc or about another pole counts within a turn.
proves: nct-5.4-multi
=== main
G0 X100 Y0 Z0 F1000
G17 G16 G90 G02 X100 Y-990 Z50 R-100
G3 X100 Y-180 I0 J-100 Z0
G15 G0 X50 Y0
G16 G3 X50 Y-400 I-50
M30
=== truth
rapid 100 0 0
feed 0 100 50 center 0 0 0 sweep -990
feed -100 0 0 center 0 0 50 sweep 810
rapid 50 0 0
feed 38.3022 -32.1394 0 center 0 0 0 sweep 320
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 100 0 0 t0.4
2: feed arc to 0 100 50 center 0 0 0 normal 0 0 1 sweep -990 F1000.4186 t103.6726
3: feed arc to -100 0 0 center 0 0 50 normal 0 0 1 sweep 810 F1000.6252 t84.823
4: rapid to 50 0 0 t0.6
5: feed arc to 38.3022 -32.1394 0 center 0 0 0 normal 0 0 1 sweep 320 F1000 t16.7552
6: event end code="M30"
end of program: 6 blocks, 5 motions, 0 errors, 0 warnings
