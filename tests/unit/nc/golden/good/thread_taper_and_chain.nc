=== about
The lead counts along the axis with the longer way; E is turns per inch; a chain of threads starts once, at Q; the
lead stays for the next block; 20 mm at lead 2 are 10 turns, 6 s at 100 rpm; along X 8 mm at E8 (3.175) 1.5118 s.
proves: nct-4.4-E nct-4.4-Q nct-4.4-chain nct-1.1-E
=== main
G0 Z0 S100 M3
G33 X4 Z-20 F2 Q180
Z-30 Q90
X12 Z-35 E8
G0 X20
G33 Z-40 Q90
M30
=== truth
thread 4 0 -20 t 6
thread 4 0 -30 t 3
thread 12 0 -35 t 1.5118
rapid 20 0 -35
thread 20 0 -40 t 0.9449
=== says
thread lead=2 angle=180
thread lead=3.175 angle=90
=== expect
file 0 main.nc
1: event spindle rpm=100 direction="cw"
2: event thread lead=2 angle=180
2: thread from 0 0 0 to 4 0 -20 F203.9608 t6
3: thread to 4 0 -30 F200 t3
4: thread to 12 0 -35 F374.4111 t1.5118
5: rapid to 20 0 -35 t0.032
6: event thread lead=3.175 angle=90
6: thread to 20 0 -40 F317.5 t0.9449
7: event end code="M30"
end of program: 7 blocks, 5 motions, 0 errors, 0 warnings
