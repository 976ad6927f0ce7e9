=== about
P5 at 600 rpm: half a second in G95, 5 s in G94, and 5 s in G95 too with N1337.SEC.
proves: nct-8-G4 nct-3-G4
=== main
G0 S600 M3
#3001=0
G95 G4 P5
X[#3001/1000]
#3001=0
G94 G4 P5
Y[#3001/1000]
G10 L52
N1337 Q1 R1
G11
#3001=0
G95 G4 P5
Z[#3001/1000]
M30
=== truth
0.5 0 0
0.5 5 0
0.5 5 5
=== says
dwell seconds=0.5
dwell seconds=5
dwell seconds=5
=== expect
file 0 main.nc
1: event spindle rpm=600 direction="cw"
3: event dwell seconds=0.5
4: rapid from 0 0 0 to 0.5 0 0 t0.002
6: event dwell seconds=5
7: rapid to 0.5 5 0 t0.02
12: event dwell seconds=5
13: rapid to 0.5 5 5 t0.02
14: event end code="M30"
end of program: 14 blocks, 3 motions, 0 errors, 0 warnings
