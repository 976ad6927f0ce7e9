=== about
M, S, T before the milling; G91 and G1 hold again afterwards.
proves: nct-23.6-MST
=== settings
D1 = 5
=== main
G17 G91
G1 Z2 F100
G65 P9999 X50 Z-5 K2 D1 Q5 F200 M3 S1200 T7
X1
M30
=== truth
feed 0 0 2
feed 0.0000 0.0000 -5.0000
feed -20.0000 0.0000 -5.0000
feed 20.0000 0.0000 -5.0000
rapid 20.0000 0.0000 2.0000
rapid 0.0000 0.0000 2.0000
feed 1 0 2
=== expect
file 0 main.nc
2: feed from 0 0 0 to 0 0 2 F100 t1.2
file 1 O9999 (built in)
1/1 depth 1: event spindle rpm=1200 direction="cw"
1/6 depth 1: feed to 0 0 -5 F100 t4.2
1/8 depth 1: feed to -20 0 -5 F100 t12
1/9 depth 1: feed to 20 0 -5 F100 t24
1/34 depth 1: rapid to 20 0 2 t0.028
1/35 depth 1: rapid to 0 0 2 t0.08
4: feed to 1 0 2 F200 t0.3
5: event end code="M30"
end of program: 24 blocks, 7 motions, 0 errors, 0 warnings
