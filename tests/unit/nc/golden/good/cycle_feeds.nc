=== about
F and S of a cycle stay behind G80 and act from their block on. Feed out of G85 and G89: N1502 percent of F, or I. S600 in the block of the hole turns
the spindle there; F0.5 in G95 is then 300 mm/min.
proves: nct-18-F nct-18-I nct-18-S
=== settings
N1502 = 40
=== main
G0 Z2 S500 M3
G85 X10 Z-8 R2 F100
G89 X20 I250
F200
G85 X30
G95 X40 F0.5 S600
G80
G1 X50
M30
=== truth
0 0 2
10 0 2
feed 10 0 -8 F 100 S 500
feed 10 0 2 F 40
20 0 2
feed 20 0 -8 F 100
feed 20 0 2 F 250
30 0 2
feed 30 0 -8 F 200 S 500
feed 30 0 2 F 500
40 0 2
feed 40 0 -8 F 300 S 600
feed 40 0 2 F 750
feed 50 0 2 F 300
=== expect
file 0 main.nc
1: event spindle rpm=500 direction="cw"
1: rapid from 0 0 0 to 0 0 2 t0.008
2: rapid to 10 0 2 t0.04
2: feed to 10 0 -8 F100 t6
2: feed to 10 0 2 F40 t15
3: rapid to 20 0 2 t0.04
3: feed to 20 0 -8 F100 t6
3: feed to 20 0 2 F250 t2.4
5: rapid to 30 0 2 t0.04
5: feed to 30 0 -8 F200 t3
5: feed to 30 0 2 F500 t1.2
6: rapid to 40 0 2 t0.04
6: event spindle rpm=600 direction="cw"
6: feed to 40 0 -8 F300 t2
6: feed to 40 0 2 F750 t0.8
8: feed to 50 0 2 F300 t2
9: event end code="M30"
end of program: 9 blocks, 14 motions, 0 errors, 0 warnings
