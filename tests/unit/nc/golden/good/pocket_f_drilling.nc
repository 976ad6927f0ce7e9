=== about
P-F
proves: nct-23.6-special
=== settings
D1 = 5
=== main
G17 G90
G0 X0 Y0 Z2
G65 P9999 Z10 K2 D1 Q4 F100
M30
=== truth
rapid 0 0 2
feed 0.0000 0.0000 -3.3333
rapid 0.0000 0.0000 -1.3333
feed 0.0000 0.0000 -6.6667
rapid 0.0000 0.0000 -4.6667
feed 0.0000 0.0000 -10.0000
rapid 0.0000 0.0000 2.0000
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 0 0 2 t0.008
file 1 O9999 (built in)
1/6 depth 1: feed to 0 0 -3.3333 F50 t6.4
1/34 depth 1: rapid to 0 0 -1.3333 t0.008
1/6 depth 1: feed to 0 0 -6.6667 F50 t6.4
1/34 depth 1: rapid to 0 0 -4.6667 t0.008
1/6 depth 1: feed to 0 0 -10 F50 t6.4
1/34 depth 1: rapid to 0 0 2 t0.048
4: event end code="M30"
end of program: 42 blocks, 7 motions, 0 errors, 0 warnings
