=== about
N1401 = 5: rows 1 to 5 of the offset tables are one for all channels, row 6 is each channel's own.
proves: nct-10.2-channels nct-15.1-N1401
=== settings
N1401 = 5
H1 = 1
H6 = 6
=== main
G10 L10 P1 R20
G10 L10 P6 R60
G43 H1 G1 Z0 F6000
M30
=== channel 2
G4 P1
G43 H1 G1 Z0 F6000
H6 Z0
M30
=== truth
0 0 20 ch 1
0 0 20 ch 2
0 0 6 ch 2
=== expect
file 0 main.nc
[1] 3: feed from 0 0 0 to 0 0 20 F6000 t0.2
file 1 channel2.nc
[2] 1/1: event dwell seconds=1
[1] 4: event end code="M30"
[2] 1/2: feed from 0 0 0 to 0 0 20 F6000 t0.2
[2] 1/3: feed to 0 0 6 F6000 t0.14
[2] 1/4: event end code="M30"
cycle 1.34 s
end of program: 8 blocks, 3 motions, 0 errors, 0 warnings
