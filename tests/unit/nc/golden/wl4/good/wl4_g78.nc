=== about
Digest wl4, 10.5, TEST_G78 with the allowance on the side of the stock (G42): the offset contour as a finishing pass.
proves: wl4-11.11.3-G78
=== settings
control = wl4-lathe
=== main
%TEST_G78
G54 G95 S500 M3
N12 G0 X10 Z40
N11 G78 G42 G0 X10 Z5 P120 Q124 R0.5 F0.3
M2
N120 G1 X8.5
N121 G1 X8 Z15
N122 G3 X7 Z20 R10
N123 G2 X5 Z25 R8
N124 G1 Z40
%
=== truth
rapid 5 0 40
rapid 5 0 5.5
feed 4.7377 0 5.5
feed 4.5010 0 14.9681
feed 3.9691 0 20.1732 center -5.8812 0 16.5369
feed 3.9335 0 20.2492 center 3.5 0 20
feed 2.9960 0 24.9367 center 10.4356 0 23.9871
feed 3 0 25 center 2.5 0 25
feed 3 0 40
rapid 5 0 40
=== expect
file 0 main.nc
2: event spindle rpm=500 direction="cw"
3 N12: rapid from 0 0 0 to 5 0 40 t0.16
main.nc:4:1: warning[wl4-monotone]: the contour of G78 turns back along X
    N11 G78 G42 G0 X10 Z5 P120 Q124 R0.5 F0.3
    ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
4 N11: rapid to 5 0 5.5 t0.138
4 N11: feed to 4.7377 0 5.5 F150 t0.1049
4 N11: feed to 4.501 0 14.9681 F150 t3.7884
4 N11: feed arc to 3.9691 0 20.1732 center -5.8812 0 16.5369 normal 0 1 0 sweep -28.8544 F150 t2.1151
4 N11: feed arc to 3.9335 0 20.2492 center 3.5 0 20 normal 0 1 0 sweep -9.6317 F150 t0.0336
4 N11: feed arc to 2.996 0 24.9367 center 10.4356 0 23.9871 normal 0 1 0 sweep 37.1673 F150 t1.9461
4 N11: feed arc to 3 0 25 center 2.5 0 25 normal 0 1 0 sweep -7.2737 F150 t0.0254
4 N11: feed to 3 0 40 F150 t6
4 N11: rapid to 5 0 40 t0.008
5: event end code="M2"
end of program: 4 blocks, 10 motions, 0 errors, 1 warnings
