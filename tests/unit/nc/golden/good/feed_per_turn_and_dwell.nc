=== about
F0.5 at 600 rpm is 300 mm/min; P5 in G95 at 600 rpm is 0.5 s.
proves: nct-6.2.1-G94 nct-6.2.1-G95 nct-8-G4 nct-6.2-F nct-11.2-M3 nct-11.2-M5 nct-11.1-S nct-3-G94 nct-3-G95 nct-3-G4
=== main
G94 G1 X10 F100
S600 M3
G4 P5
G95 G1 X20 F0.5
G4 P5
G94 G4 P2.5
M5
M30
=== truth
10 0 0 F 100 t 6
20 0 0 F 300 t 2
=== expect
file 0 main.nc
1: feed from 0 0 0 to 10 0 0 F100 t6
2: event spindle rpm=600 direction="cw"
3: event dwell seconds=5
4: feed to 20 0 0 F300 t2
5: event dwell seconds=0.5
6: event dwell seconds=2.5
7: event spindle rpm=0 direction="stop"
8: event end code="M30"
end of program: 8 blocks, 2 motions, 0 errors, 0 warnings
