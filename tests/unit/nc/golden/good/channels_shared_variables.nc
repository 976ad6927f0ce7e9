=== about
N1700 = 2: #100 and #101 are one for all channels, #102 is not; N1701 = 1: #500 is, #501 is not. Channel 2 asks
for #101 in a loop until channel 1 has set it, at 2 s.
proves: nct-1.2-channel
=== settings
N1700 = 2
N1701 = 1
=== main
#100=30
#102=50
#500=7
#501=8
G1 X100 F6000
X200
#101=1
X300
M30
=== channel 2
G4 P0.1
G1 Y#100 F6000
IF[#102 NE #0] GOTO 90
IF[#501 NE #0] GOTO 90
Z#500
WHILE[#101 NE 1] DO1
END1
N90 Z0
M30
=== truth
100 0 0 t 1 ch 1
0 30 0 t 0.3 ch 2
0 30 7 t 0.07 ch 2
200 0 0 t 1 ch 1
300 0 0 t 1 ch 1
0 30 0 t 0.07 ch 2
=== says
cycle 3 s
=== expect
file 0 main.nc
[1] 5: feed from 0 0 0 to 100 0 0 F6000 t1
file 1 channel2.nc
[2] 1/1: event dwell seconds=0.1
[2] 1/2: feed from 0 0 0 to 0 30 0 F6000 t0.3
[2] 1/5: feed to 0 30 7 F6000 t0.07
[1] 6: feed to 200 0 0 F6000 t1
[2] 1/7: event wait t0.53
[1] 8: feed to 300 0 0 F6000 t1
[2] 1/7: event wait t1
[2] 1/8 N90: feed to 0 30 0 F6000 t0.07
[2] 1/9: event end code="M30"
[1] 9: event end code="M30"
cycle 3 s
end of program: 10033 blocks, 6 motions, 0 errors, 0 warnings
