=== about
Motions come in the order in which they start; the cycle ends with the last channel. Channels have tools, start
positions, work offsets and lengths of time of their own. Both programs call the same subprogram.
proves: nct-10.2-channels nct-1.2-channel
=== settings
G55 = 10 0 0
tool = 1
=== sub O0011.nc
X5
M99
=== main
G1 X100 F6000
G10 L2 P2 X20 Y0 Z0
G55 X0
G4 P0.5
M98 P11
M30
=== channel 2 tool = 7; start = 0 50 0; G55 = 30 0 0
G1 Y80 F6000
Y100
G55 X0
M98 P11
X0
M30
=== truth
100 0 0 t 1 T 1 ch 1
0 80 0 t 0.3 T 7 ch 2
0 100 0 t 0.2 T 7 ch 2
30 100 0 t 0.3 T 7 ch 2
35 100 0 t 0.05 ch 2
30 100 0 t 0.05 ch 2
20 0 0 t 0.8 ch 1
25 0 0 t 0.05 ch 1
=== says
[2] 1/6: event end
[1] 6: event end
cycle 2.35 s
=== expect
file 0 main.nc
[1] 1: feed from 0 0 0 to 100 0 0 F6000 t1
file 1 channel2.nc
[2] 1/1: feed from 0 50 0 to 0 80 0 F6000 t0.3
[2] 1/2: feed to 0 100 0 F6000 t0.2
[2] 1/3: feed to 30 100 0 F6000 t0.3
file 2 O0011.nc
[2] 2/1 depth 1: feed to 35 100 0 F6000 t0.05
[2] 1/5: feed to 30 100 0 F6000 t0.05
[2] 1/6: event end code="M30"
[1] 3: feed to 20 0 0 F6000 t0.8
[1] 4: event dwell seconds=0.5
file 3 O0011.nc
[1] 3/1 depth 1: feed to 25 0 0 F6000 t0.05
[1] 6: event end code="M30"
cycle 2.35 s
end of program: 16 blocks, 8 motions, 0 errors, 0 warnings
