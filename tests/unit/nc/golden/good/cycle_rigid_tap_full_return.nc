=== about
N1503.PTC: back to R between the pecks, then down to E (or N1505) above the last depth.
proves: nct-18.1.10-PTC
=== settings
N1503.PTC = 1
N1505 = 1.5
=== main
G0 Z2 S100 M3
G99 G84.2 X10 Z-10 R2 Q5 F100
G80
G84.3 X20 Z-10 R2 Q8 E3
M30
=== truth
0 0 2
10 0 2
thread 10 0 -3
thread 10 0 2
thread 10 0 -1.5
thread 10 0 -8
thread 10 0 2
thread 10 0 -6.5
thread 10 0 -10
thread 10 0 2
20 0 2
thread 20 0 -6
thread 20 0 2
thread 20 0 -3
thread 20 0 -10
thread 20 0 2
=== expect
file 0 main.nc
1: event spindle rpm=100 direction="cw"
1: rapid from 0 0 0 to 0 0 2 t0.008
2: rapid to 10 0 2 t0.04
2: event spindle rpm=0 direction="position loop"
2: thread to 10 0 -3 F100 t3
2: thread to 10 0 2 F100 t3
2: thread to 10 0 -1.5 F100 t2.1
2: thread to 10 0 -8 F100 t3.9
2: thread to 10 0 2 F100 t6
2: thread to 10 0 -6.5 F100 t5.1
2: thread to 10 0 -10 F100 t2.1
2: thread to 10 0 2 F100 t7.2
4: rapid to 20 0 2 t0.04
4: event spindle rpm=0 direction="position loop"
4: thread to 20 0 -6 F100 t4.8
4: thread to 20 0 2 F100 t4.8
4: thread to 20 0 -3 F100 t3
4: thread to 20 0 -10 F100 t4.2
4: thread to 20 0 2 F100 t7.2
5: event end code="M30"
end of program: 5 blocks, 16 motions, 0 errors, 0 warnings
