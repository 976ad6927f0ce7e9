=== about
Digest wl4, 10.4: passes along the contour; equidistant 4, 2, 0.5, linear (3.1430, 1.2572) (1.2861, 0.5144) (0.5, 0.2), finishing.
proves: wl4-11.8.1-G76 wl4-11.8.2-G76 wl4-11.8.3-G76
=== settings
control = wl4-lathe
=== main
%APPROACH
G54 G95 S500 M3
G0 X60 Z10
G76 G41 G1 X20 Z0 P10 Q10 R0.5 C6 E2 F0.2
G76 G0 X20 Z0 P10 Q10 I0.5 K0.2 U5 W2 E2 F0.2
G76 G0 X20 Z0 P10 Q10 F0.1
M2
N10 G1 Z-30
%
=== truth
rapid 30 0 10
feed 14 0 0
feed 14 0 -30
rapid 30 0 -30
rapid 30 0 10
feed 12 0 0
feed 12 0 -30
rapid 30 0 -30
rapid 30 0 10
feed 10.5 0 0
feed 10.5 0 -30
rapid 30 0 -30
rapid 30 0 10
rapid 13.1430 0 1.2572
feed 13.1430 0 -28.7428
rapid 30 0 -28.7428
rapid 30 0 10
rapid 11.2861 0 0.5144
feed 11.2861 0 -29.4856
rapid 30 0 -29.4856
rapid 30 0 10
rapid 10.5 0 0.2
feed 10.5 0 -29.8
rapid 30 0 -29.8
rapid 30 0 10
rapid 10 0 0
feed 10 0 -30
rapid 30 0 -30
rapid 30 0 10
=== expect
file 0 main.nc
2: event spindle rpm=500 direction="cw"
3: rapid from 0 0 0 to 30 0 10 t0.12
4: feed to 14 0 0 F100 t11.3208
4: feed to 14 0 -30 F100 t18
4: rapid to 30 0 -30 t0.064
4: rapid to 30 0 10 t0.16
4: feed to 12 0 0 F100 t12.3548
4: feed to 12 0 -30 F100 t18
4: rapid to 30 0 -30 t0.072
4: rapid to 30 0 10 t0.16
4: feed to 10.5 0 0 F100 t13.1488
4: feed to 10.5 0 -30 F100 t18
4: rapid to 30 0 -30 t0.078
4: rapid to 30 0 10 t0.16
5: rapid to 13.143 0 1.2572 t0.0674
5: feed to 13.143 0 -28.7428 F100 t18
5: rapid to 30 0 -28.7428 t0.0674
5: rapid to 30 0 10 t0.155
5: rapid to 11.2861 0 0.5144 t0.0749
5: feed to 11.2861 0 -29.4856 F100 t18
5: rapid to 30 0 -29.4856 t0.0749
5: rapid to 30 0 10 t0.1579
5: rapid to 10.5 0 0.2 t0.078
5: feed to 10.5 0 -29.8 F100 t18
5: rapid to 30 0 -29.8 t0.078
5: rapid to 30 0 10 t0.1592
6: rapid to 10 0 0 t0.08
6: feed to 10 0 -30 F50 t36
6: rapid to 30 0 -30 t0.08
6: rapid to 30 0 10 t0.16
7: event end code="M2"
end of program: 6 blocks, 29 motions, 0 errors, 0 warnings
