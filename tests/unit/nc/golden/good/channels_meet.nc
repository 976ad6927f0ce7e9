=== about
Three channels and two waiting points (manual 14.5): the first two meet at M501, then all at M502.
At 100 mm/s: channel 1 is at M501 after 1 s, channel 2 after 2 s; at M502 they are after 2.5, 2.1 and 0.5 s.
proves: nct-1.2-channel nct-1.2-sync nct-14.5-wait
=== settings
N2201 = 500
N2202 = 599
=== main
N10 G1 X100 F6000
N60 M501 P12
N70 X150
N130 M502 P123
N140 X160
M30
=== channel 2
N10 G1 Y200 F6000
N100 M501 P12
N110 Y210
M502 P123
Y220
M30
=== channel 3
N10 G1 Z-50 F6000
N110 M502 P123
N120 Z-60
M30
=== truth
100 0 0 t 1 ch 1
0 200 0 t 2 ch 2
0 0 -50 t 0.5 ch 3
150 0 0 t 0.5 ch 1
0 210 0 t 0.1 ch 2
160 0 0 t 0.1 ch 1
0 220 0 t 0.1 ch 2
0 0 -60 t 0.1 ch 3
=== says
[1] 2 N60: event wait code="M501" channels="12" t1
[2] 1/2 N100: event wait code="M501" channels="12" t0
[2] 1/4: event wait code="M502" channels="123" t0.4
[3] 2/2 N110: event wait code="M502" channels="123" t2
cycle 2.6 s
=== expect
file 0 main.nc
[1] 1 N10: feed from 0 0 0 to 100 0 0 F6000 t1
file 1 channel2.nc
[2] 1/1 N10: feed from 0 0 0 to 0 200 0 F6000 t2
file 2 channel3.nc
[3] 2/1 N10: feed from 0 0 0 to 0 0 -50 F6000 t0.5
[1] 2 N60: event wait code="M501" channels="12" t1
[1] 3 N70: feed to 150 0 0 F6000 t0.5
[2] 1/2 N100: event wait code="M501" channels="12" t0
[2] 1/3 N110: feed to 0 210 0 F6000 t0.1
[1] 4 N130: event wait code="M502" channels="123" t0
[1] 5 N140: feed to 160 0 0 F6000 t0.1
[2] 1/4: event wait code="M502" channels="123" t0.4
[2] 1/5: feed to 0 220 0 F6000 t0.1
[3] 2/2 N110: event wait code="M502" channels="123" t2
[3] 2/3 N120: feed to 0 0 -60 F6000 t0.1
[1] 6: event end code="M30"
[2] 1/6: event end code="M30"
[3] 2/4: event end code="M30"
cycle 2.6 s
end of program: 16 blocks, 8 motions, 0 errors, 0 warnings
