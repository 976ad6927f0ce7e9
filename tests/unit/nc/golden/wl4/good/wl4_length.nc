=== about
Length offsets act with the first motion of their axis and stay with it when the plane changes; G49 ends all.
proves: wl4-6.3-G43 wl4-6.3-G44 wl4-6.3-G49 wl4-4.2-H
=== settings
control = wl4-mill
H1 = 10
H2 = 3
=== main
%LENGTH
G54 G0 Z50
G43 H1
X5
Z50
G18 G44 H2 Y1
G91 Z-5
G90 G49
Y1 Z1
M30
%
=== truth
rapid 0 0 50
rapid 5 0 50
rapid 5 0 60
rapid 5 -2 60
rapid 5 -2 55
rapid 5 1 1
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 0 0 50 t0.2
4: rapid to 5 0 50 t0.02
5: rapid to 5 0 60 t0.04
6: rapid to 5 -2 60 t0.008
7: rapid to 5 -2 55 t0.02
9: rapid to 5 1 1 t0.216
10: event end code="M30"
end of program: 9 blocks, 6 motions, 0 errors, 0 warnings
