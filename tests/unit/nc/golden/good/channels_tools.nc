=== about
The tool table is common to all channels; the spindle of channel 2 is magazine 20.
proves: nct-12.3.1-table nct-1.2-channel
=== main
G10 L75 P1
N1 T500 Q1 B2
N2 T600 Q1 B2
G11
T500 M6
G1 X#8401 F600
M30
=== channel 2
G4 P1
T600 M6
G1 Y#8401 F600
#8400=10
Z#8402
M30
=== truth
1 0 0 T 500 ch 1
0 2 0 T 600 ch 2
0 2 500 T 600 ch 2
=== expect
file 0 main.nc
[1] 5: event tool tool=500 row=1
file 1 channel2.nc
[2] 1/1: event dwell seconds=1
[2] 1/2: event tool tool=600 row=2
[1] 6: feed from 0 0 0 to 1 0 0 F600 t0.1
[1] 7: event end code="M30"
[2] 1/3: feed from 0 0 0 to 0 2 0 F600 t0.2
[2] 1/5: feed to 0 2 500 F600 t50
[2] 1/6: event end code="M30"
cycle 56.2 s
end of program: 13 blocks, 3 motions, 0 errors, 0 warnings
