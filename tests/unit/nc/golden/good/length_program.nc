=== about
proves: nct-15.3-ZAX nct-15.3-G43 nct-15.1-row0
=== settings
H1 = 400
=== main
N1 G90 G0 X500 Y600
N2 G43 G17 Z410 H1
N3 G1 Z100 F180
N4 G4 P2
N5 G0 Z1100 H0
N6 X-800 Y-300
M30
=== truth
500 600 0
500 600 810
500 600 500
500 600 1100
-800 -300 1100
=== expect
file 0 main.nc
1 N1: rapid from 0 0 0 to 500 600 0 t2.4
2 N2: rapid to 500 600 810 t3.24
3 N3: feed to 500 600 500 F180 t103.3333
4 N4: event dwell seconds=2
5 N5: rapid to 500 600 1100 t2.4
6 N6: rapid to -800 -300 1100 t5.2
7: event end code="M30"
end of program: 7 blocks, 5 motions, 0 errors, 0 warnings
