=== about
The manual's internal thread in two passes: 102 mm are 51 turns of lead 2, 30.6 s at 100 rpm. The lead of 2 does
not become the feed.
proves: nct-4.4-G33 nct-4.4-F nct-1.1-Q
=== main
N50 G90 G0 X0 Y0 S100 M4
N55 Z2
N60 G33 Z-100 F2
N65 M19
N70 G0 X5
N75 Z2 M0
N80 X0 M4
N85 G4 P2
N90 G33 Z-100 F2
N95 G1 X1 F60
M30
=== truth
rapid 0 0 2
thread 0 0 -100 F 200 t 30.6
rapid 5 0 -100
rapid 5 0 2
rapid 0 0 2
thread 0 0 -100 F 200 t 30.6
feed 1 0 -100 F 60
=== expect
file 0 main.nc
1 N50: event spindle rpm=100 direction="ccw"
2 N55: rapid from 0 0 0 to 0 0 2 t0.008
3 N60: event thread lead=2 angle=0
3 N60: thread to 0 0 -100 F200 t30.6
4 N65: event spindle rpm=0 direction="oriented"
5 N70: rapid to 5 0 -100 t0.02
6 N75: rapid to 5 0 2 t0.408
6 N75: event stop code="M0"
7 N80: event spindle rpm=100 direction="ccw"
7 N80: rapid to 0 0 2 t0.02
8 N85: event dwell seconds=2
9 N90: event thread lead=2 angle=0
9 N90: thread to 0 0 -100 F200 t30.6
10 N95: feed to 1 0 -100 F60 t1
11: event end code="M30"
end of program: 11 blocks, 7 motions, 0 errors, 0 warnings
