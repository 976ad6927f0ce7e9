=== about
Stops, coolant, gears, functions of the machine are told in the path; the codes in force are read.
proves: wl4-7.4-M0 wl4-7.4-M1 wl4-7.4-M7 wl4-7.4-M8 wl4-7.4-M9 wl4-7.4-M10 wl4-7.4-M31 wl4-7.4-M30 wl4-7.4-M40 wl4-4.2-M wl4-7.4-max wl4-9.2-112 wl4-9.2-114 wl4-5-reset wl4-5-order wl4-9.2-101 wl4-9.2-107 wl4-9.2-132 wl4-9.2-133 wl4-9.2-137 wl4-9.2-138
=== settings
control = wl4-mill
=== main
%MACHINE
X#103 Y#101 Z#107
X#102 Y#104 Z#105
G54 M3 M8 M42 S100
M0
M1
M10 M31 M7
X#112 Y#114 Z#117
G0 G1 G0 X1 Y2 Z3
G91 Y4
Y4
G90 X#132 Y#133
M9 M5
G3 X10 Y4 J5 F100
G0 X#137 Z#138
M30
%
=== truth
rapid 53 0 80
rapid 40 90 94
rapid 3 7 42
rapid 1 2 3
rapid 1 6 3
rapid 1 10 3
rapid 10 4 3
feed 10 4 3 center 10 9 3 sweep 360
rapid 5 4 0
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 53 0 80 t0.32
3: rapid to 40 90 94 t0.36
4: event spindle rpm=100 direction="cw"
4: event coolant code="M8" on=true
4: event function code="M42"
5: event stop code="M0"
6: event optional_stop code="M1" active=false
7: event function code="M10"
7: event function code="M31"
7: event coolant code="M7" on=true
8: rapid to 3 7 42 t0.332
9: rapid to 1 2 3 t0.156
10: rapid to 1 6 3 t0.016
11: rapid to 1 10 3 t0.016
12: rapid to 10 4 3 t0.036
13: event coolant code="M9" on=false
13: event spindle rpm=0 direction="stop"
14: feed arc to 10 4 3 center 10 9 3 normal 0 0 1 sweep 360 F100 t18.8496
15: rapid to 5 4 0 t0.02
16: event end code="M30"
end of program: 15 blocks, 9 motions, 0 errors, 0 warnings
