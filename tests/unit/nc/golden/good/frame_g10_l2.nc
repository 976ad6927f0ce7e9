=== about
proves: nct-10.2.1-common nct-3-G10 nct-10.2.4-G10L2
=== main
G90 G10 L2 P1 X300 Y800
G90 G10 L2 P2 X1300 Y400
G54 G0 X700 Y500
G55
X-300 Y900
X0 Y0
G91 G10 L2 P1 X10
G90 G54 X0 Y0
G90 G10 L2 P1 XI10
X0
G90 G10 L2 P0 X5 Y5
X0 Y0
M30
=== truth
1000 1300 0
1300 400 0
310 800 0
320 800 0
325 805 0
=== expect
file 0 main.nc
3: rapid from 0 0 0 to 1000 1300 0 t5.2
6: rapid to 1300 400 0 t3.6
8: rapid to 310 800 0 t3.96
10: rapid to 320 800 0 t0.04
12: rapid to 325 805 0 t0.02
13: event end code="M30"
end of program: 13 blocks, 5 motions, 0 errors, 0 warnings
