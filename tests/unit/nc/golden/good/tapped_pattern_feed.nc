=== about
F and S of tapping: pitch is F/S in G94 and F in G95.
proves: nct-18-F nct-18.1.9-G84.2
=== main
G0 Z10 S1000 M3
G99 G84.2 X0 Y0 Z-30 R2 F1000
G95 X10 F1
M30
=== truth
0 0 10
0 0 2
thread 0 0 -30 F 1000
thread 0 0 2 F 1000
rapid 10 0 2
thread 10 0 -30 F 1000
thread 10 0 2 F 1000
=== expect
file 0 main.nc
1: event spindle rpm=1000 direction="cw"
1: rapid from 0 0 0 to 0 0 10 t0.04
2: rapid to 0 0 2 t0.032
2: event spindle rpm=0 direction="position loop"
2: thread to 0 0 -30 F1000 t1.92
2: thread to 0 0 2 F1000 t1.92
3: rapid to 10 0 2 t0.04
3: event spindle rpm=0 direction="position loop"
3: thread to 10 0 -30 F1000 t1.92
3: thread to 10 0 2 F1000 t1.92
4: event end code="M30"
end of program: 4 blocks, 7 motions, 0 errors, 0 warnings
