=== about
Rigid taps of pitch 2 at 600 rpm, 20 mm/s: the spindle takes 1200 rpm a second in, 600 out (N1503.EAE); on the way in
20 mm take 20/20 + 20/40, out 20/20 + 20/20 seconds. With returns to R at 200 % (N1503.ROE).
proves: nct-18.1.9-EAE nct-18.1.10-ROE
=== settings
N1503.EAE = 1
N1508 = 1200
N1524 = 600
N1503.PTC = 1
N1505 = 2
N1507 = 200
=== main
G0 Z2 S600 M3
G99 G84.2 X0 Y0 Z-18 R2 F1200
G80
G10 L52
N1503 Q5 R1
N1508 P1 R0
N1524 P1 R0
G11
G99 G84.2 X10 Z-18 R2 Q10 F1200
M30
=== truth
rapid 0 0 2
thread 0 0 -18 F 1200 t 1.5
thread 0 0 2 F 1200 t 2
rapid 10 0 2
thread 10 0 -8 F 1200 t 0.5
thread 10 0 2 F 2400 t 0.25
thread 10 0 -6 F 2400 t 0.2
thread 10 0 -18 F 1200 t 0.6
thread 10 0 2 F 1200 t 1
=== expect
file 0 main.nc
1: event spindle rpm=600 direction="cw"
1: rapid from 0 0 0 to 0 0 2 t0.008
2: event spindle rpm=0 direction="position loop"
2: thread to 0 0 -18 F1200 t1.5
2: thread to 0 0 2 F1200 t2
9: rapid to 10 0 2 t0.04
9: event spindle rpm=0 direction="position loop"
9: thread to 10 0 -8 F1200 t0.5
9: thread to 10 0 2 F2400 t0.25
9: thread to 10 0 -6 F2400 t0.2
9: thread to 10 0 -18 F1200 t0.6
9: thread to 10 0 2 F1200 t1
10: event end code="M30"
end of program: 10 blocks, 9 motions, 0 errors, 0 warnings
