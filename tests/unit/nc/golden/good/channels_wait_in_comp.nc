=== about
A waiting code empties the buffer: the compensation vector is dropped there and comes back with the next motion.
proves: nct-14.5-wait
=== settings
D1 = 5
N2201 = 500
N2202 = 500
=== main
G41 D1 G1 X50 F600
Y50
M500 P12
Y80
G40 X0
M30
=== channel 2
M500 P12
M30
=== truth
45 0 0 t 4.5 ch 1
50 50 0 ch 1
45 80 0 ch 1
0 80 0 ch 1
=== says
[2] 1/1: event wait code="M500" channels="12" t9.5249
=== expect
file 0 main.nc
[1] 1: feed from 0 0 0 to 45 0 0 F600 t4.5
file 1 channel2.nc
[1] 2: feed to 50 50 0 F600 t5.0249
[1] 3: event wait code="M500" channels="12" t0
[1] 4: feed to 45 80 0 F600 t3.0414
[2] 1/1: event wait code="M500" channels="12" t9.5249
[2] 1/2: event end code="M30"
[1] 5: feed to 0 80 0 F600 t4.5
[1] 6: event end code="M30"
cycle 17.0663 s
end of program: 8 blocks, 4 motions, 0 errors, 0 warnings
