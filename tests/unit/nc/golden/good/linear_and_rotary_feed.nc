=== about
The feed counts on all axes, millimetres and degrees alike: Z100 C45 at F120 takes 54.8293 s; a rotary axis alone goes by
degrees a minute. A table turns the part: the path in the part is a helix, or a circle.
proves: nct-4.2-G1 nct-4.2-F nct-2.4-units nct-1.1-ABC nct-4.1-G0
=== settings
axis = C 4 rotary rapid 3600
=== main
G0 X10
G91 G01 Z100 C45 F120
G90 G0 Z0
G1 C270 F120
G0 C0
X20 C90
G20 G1 X0 C0 F10
M30
=== truth
rapid 10 0 0
feed 7.0711 7.0711 100 center 0 0 0 sweep 45 t 54.8293
rapid 7.0711 7.0711 0
feed 0 -10 0 center 0 0 0 sweep 225 t 112.5
rapid 10 0 0 center 0 0 0 sweep -270 t 4.5
rapid 0 20 0 center 0 0 0 sweep 90 t 1.5
feed 0 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 10 0 0 C 0 to 0 t0.04
2: feed arc to 7.0711 7.0711 100 center 0 0 0 normal 0 0 1 sweep 45 C 0 to 45 F109.7676 t54.8293
3: rapid to 7.0711 7.0711 0 C 45 to 45 t0.4
4: feed arc to 0 -10 0 center 0 0 0 normal 0 0 1 sweep 225 C 45 to 270 F20.944 t112.5
5: rapid arc to 10 0 0 center 0 0 0 normal 0 0 1 sweep -270 C 270 to 0 t4.5
6: rapid arc to 0 20 0 center 0 0 0 normal 0 0 1 sweep 90 C 0 to 90 t1.5
7: feed arc to 0 0 0 center 0 0 0 normal 0 0 1 sweep -90 C 90 to 0 F72.9337 t21.7785
8: event end code="M30"
end of program: 8 blocks, 7 motions, 0 errors, 0 warnings
