=== about
Digest wl4, 10.5, closed-zone test: the pocket is cut behind the passes before it.
proves: wl4-11.9.1-G77
=== settings
control = wl4-lathe
=== main
%POCKET
G54 G95 S500 M3
G0 X60 Z2
G77 G0 X20 Z0 P10 Q16 E5 F0.2
M2
N10 G1 Z-10
N11 X40
N12 Z-20
N13 X24 Z-30
N14 Z-40
N15 X40 Z-50
N16 X50 Z-60
%
=== truth
rapid 30 0 2
rapid 30 0 0
rapid 25 0 0
feed 25 0 -60
rapid 30 0 -60
rapid 30 0 0
rapid 25 0 0
rapid 20 0 0
feed 20 0 -50
feed 25 0 -60
rapid 25 0 0
rapid 20 0 0
rapid 15 0 0
feed 15 0 -10
feed 20 0 -10
rapid 20 0 0
rapid 15 0 0
rapid 10 0 0
feed 10 0 -10
feed 15 0 -10
rapid 25 0 -10
rapid 25 0 -20
rapid 20 0 -20
feed 15 0 -26.25
feed 15 0 -43.75
feed 20 0 -50
rapid 20 0 -26.25
rapid 15 0 -26.25
feed 12 0 -30
feed 12 0 -40
feed 15 0 -43.75
rapid 30 0 -43.75
rapid 30 0 2
=== expect
file 0 main.nc
2: event spindle rpm=500 direction="cw"
3: rapid from 0 0 0 to 30 0 2 t0.12
4: rapid to 30 0 0 t0.008
4: rapid to 25 0 0 t0.02
4: feed to 25 0 -60 F100 t36
4: rapid to 30 0 -60 t0.02
4: rapid to 30 0 0 t0.24
4: rapid to 25 0 0 t0.02
4: rapid to 20 0 0 t0.02
4: feed to 20 0 -50 F100 t30
4: feed to 25 0 -60 F100 t6.7082
4: rapid to 25 0 0 t0.24
4: rapid to 20 0 0 t0.02
4: rapid to 15 0 0 t0.02
4: feed to 15 0 -10 F100 t6
4: feed to 20 0 -10 F100 t3
4: rapid to 20 0 0 t0.04
4: rapid to 15 0 0 t0.02
4: rapid to 10 0 0 t0.02
4: feed to 10 0 -10 F100 t6
4: feed to 15 0 -10 F100 t3
4: rapid to 25 0 -10 t0.04
4: rapid to 25 0 -20 t0.04
4: rapid to 20 0 -20 t0.02
4: feed to 15 0 -26.25 F100 t4.8023
4: feed to 15 0 -43.75 F100 t10.5
4: feed to 20 0 -50 F100 t4.8023
4: rapid to 20 0 -26.25 t0.095
4: rapid to 15 0 -26.25 t0.02
4: feed to 12 0 -30 F100 t2.8814
4: feed to 12 0 -40 F100 t6
4: feed to 15 0 -43.75 F100 t2.8814
4: rapid to 30 0 -43.75 t0.06
4: rapid to 30 0 2 t0.183
5: event end code="M2"
end of program: 4 blocks, 33 motions, 0 errors, 0 warnings
