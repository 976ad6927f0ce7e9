=== about
Digest wl4, 7: chamfers between lines and between arcs on the lathe.
proves: wl4-8.1-B
=== settings
control = wl4-lathe
=== main
%CHAMFER
G54 G95 S100 M3
N50 G0 X40 Z70
N51 G1 X100 F0.2 B10
N52 Z10
N10 G0 X60 Z80
N11 G3 X100 Z50 R50 B8 F0.2
N12 G2 X80 Z40 R40
M30
%
=== truth
rapid 20 0 70
feed 40 0 70
feed 50 0 60
feed 50 0 10
rapid 30 0 80
feed 43.85055 0 55.1170 center 78.8042 0 90.8695
feed 44.79835 0 43.9219
feed 40 0 40 center 17.1612 0 72.8388
=== expect
file 0 main.nc
2: event spindle rpm=100 direction="cw"
3 N50: rapid from 0 0 0 to 20 0 70 t0.28
4 N51: feed to 40 0 70 F20 t60
4 N51: feed to 50 0 60 F20 t42.4264
5 N52: feed to 50 0 10 F20 t150
6 N10: rapid to 30 0 80 t0.28
7 N11: feed arc to 43.8505 0 55.117 center 78.8042 0 90.8695 normal 0 1 0 sweep -33.0915 F20 t86.6332
7 N11: feed to 44.7984 0 43.9219 F20 t33.7055
8 N12: feed arc to 40 0 40 center 17.1612 0 72.8388 normal 0 1 0 sweep 8.8858 F20 t18.6104
9: event end code="M30"
end of program: 8 blocks, 8 motions, 0 errors, 0 warnings
