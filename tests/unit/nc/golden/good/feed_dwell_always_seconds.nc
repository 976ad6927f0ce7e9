=== about
proves: nct-8-G4
=== settings
N1337.SEC = 1
=== main
S600 M3
G95 G4 P5
M30
=== says
dwell seconds=5
=== expect
file 0 main.nc
1: event spindle rpm=600 direction="cw"
2: event dwell seconds=5
3: event end code="M30"
end of program: 3 blocks, 0 motions, 0 errors, 0 warnings
