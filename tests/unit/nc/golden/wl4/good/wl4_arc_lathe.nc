=== about
Digest wl4, 4.3: the lathe arc; I is a radius while X is a diameter.
proves: wl4-5.7-G18 wl4-4.2-XYZ wl4-5.13-G95
=== settings
control = wl4-lathe
=== main
%ARC
G54 G95 S100 M3
G1 X-100Z86.603F0.2
G2X0Z100I50K-86.603
G1 X40 Z0 F0.2
M30
%
=== truth
feed -50 0 86.603
feed 0 0 100 center 0 0 0 sweep 29.9999
feed 20 0 0
=== expect
file 0 main.nc
2: event spindle rpm=100 direction="cw"
3: feed from 0 0 0 to -50 0 86.603 F20 t300.0012
4: feed arc to 0 0 100 center 0 0 0 normal 0 1 0 sweep 29.9999 F20 t157.0793
5: feed to 20 0 0 F20 t305.9412
6: event end code="M30"
end of program: 5 blocks, 3 motions, 0 errors, 0 warnings
