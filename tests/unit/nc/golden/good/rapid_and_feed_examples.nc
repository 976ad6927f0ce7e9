=== about
The short examples of G0 and G1: modal codes and feed carry over; all axes of a rapid arrive together, as fast as the slowest
allows.
proves: nct-4.1-G0 nct-4.2-G1 nct-6.1-rapid nct-1.3-modal nct-3-group
=== settings
rapid = 10000 5000 2000
=== main
G90 X20 Y30 Z0
G91 X-40 Y-20 Z-5
G90
G0 X20 Y30 Z0
X10 Z1
G0 G90 X20 Y30 Z0 S2000 M3
G0 Z10
X30
Z1
G1 X80 Y115 F500
X0
G1 G91 X50 Y30 Z10 S2000 M3
M30
=== truth
rapid 20 30 0 t 0.36
rapid -20 10 -5 t 0.24
rapid 20 30 0 t 0.24
rapid 10 30 1 t 0.06
rapid 20 30 0 t 0.06
rapid 20 30 10 t 0.3
rapid 30 30 10 t 0.06
rapid 30 30 1 t 0.27
feed 80 115 1 F 500 t 11.8338 S 2000
feed 0 115 1 F 500 t 9.6
feed 50 145 11 F 500 t 7.0993
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 20 30 0 t0.36
2: rapid to -20 10 -5 t0.24
4: rapid to 20 30 0 t0.24
5: rapid to 10 30 1 t0.06
6: event spindle rpm=2000 direction="cw"
6: rapid to 20 30 0 t0.06
7: rapid to 20 30 10 t0.3
8: rapid to 30 30 10 t0.06
9: rapid to 30 30 1 t0.27
10: feed to 80 115 1 F500 t11.8338
11: feed to 0 115 1 F500 t9.6
12: event spindle rpm=2000 direction="cw"
12: feed to 50 145 11 F500 t7.0993
13: event end code="M30"
end of program: 13 blocks, 11 motions, 0 errors, 0 warnings
