=== about
Digest wl4, 7, the second example with Z to the right and X up.
proves: wl4-8.1-B
=== settings
control = wl4-lathe
param.G18_ZX = 1
=== main
%CHAMFER
G54 G95 S100 M3
N10 G0 X60 Z80
N11 G3 X100 Z50 R50 B8 F0.2
N12 G2 X80 Z40 R40
M30
%
=== truth
rapid 30 0 80
feed 47.64175 0 57.6445 center 1.1958 0 39.1305
feed 43.92195 0 44.7984
feed 40 0 40 center 72.8388 0 17.1612
=== expect
file 0 main.nc
2: event spindle rpm=100 direction="cw"
3 N10: rapid from 0 0 0 to 30 0 80 t0.32
4 N11: feed arc to 47.6418 0 57.6445 center 1.1958 0 39.1305 normal 0 1 0 sweep 33.0915 F20 t86.6332
4 N11: feed to 43.9219 0 44.7984 F20 t40.1217
5 N12: feed arc to 40 0 40 center 72.8388 0 17.1612 normal 0 1 0 sweep -8.8858 F20 t18.6104
6: event end code="M30"
end of program: 5 blocks, 4 motions, 0 errors, 0 warnings
