=== about
Allowances I and K of G78.
proves: wl4-11.11.1-G78
=== settings
control = wl4-lathe
=== main
%FACE
G54 G95 S500 M3
G0 X40 Z2
G78 G0 X30 Z-6 P10 Q12 I0.5 K0.2 E4 F0.2
M2
N10 G1 X20
N11 Z-2
N12 X10 Z0
%
=== truth
rapid 20 0 2
rapid 15.5 0 2
rapid 15.5 0 -2
feed 10.5 0 -2
feed 10.5 0 -1.8
feed 5.5 0 0.2
rapid 5.5 0 2
rapid 15.5 0 2
rapid 15.5 0 -2
rapid 15.5 0 -5.8
feed 10.5 0 -5.8
feed 10.5 0 -2
rapid 10.5 0 2
rapid 20 0 2
=== expect
file 0 main.nc
2: event spindle rpm=500 direction="cw"
3: rapid from 0 0 0 to 20 0 2 t0.08
4: rapid to 15.5 0 2 t0.018
4: rapid to 15.5 0 -2 t0.016
4: feed to 10.5 0 -2 F100 t3
4: feed to 10.5 0 -1.8 F100 t0.12
4: feed to 5.5 0 0.2 F100 t3.2311
4: rapid to 5.5 0 2 t0.0072
4: rapid to 15.5 0 2 t0.04
4: rapid to 15.5 0 -2 t0.016
4: rapid to 15.5 0 -5.8 t0.0152
4: feed to 10.5 0 -5.8 F100 t3
4: feed to 10.5 0 -2 F100 t2.28
4: rapid to 10.5 0 2 t0.016
4: rapid to 20 0 2 t0.038
5: event end code="M2"
end of program: 4 blocks, 14 motions, 0 errors, 0 warnings
