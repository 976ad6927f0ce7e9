=== about
The listings of 9.4 and 9.5: tool data, places, the tool's own offsets.
proves: nct-12.4.1-G10L75P1 nct-12.4.4-G10L76P1 nct-12.4-G11 nct-12.5.1-H99 nct-15.1-N2923 nct-12.5.3-8400 nct-23.1.20-#8400 nct-23.1.20-#8401 nct-23.1.20-#8402 nct-23.1.20-#8403 nct-23.1.20-#8404 nct-23.1.20-#8405 nct-23.1.20-#8406 nct-23.1.20-#8407 nct-23.1.20-#8408 nct-23.1.20-#8409 nct-23.1.20-#8410 nct-23.1.20-#8411 nct-23.1.20-#8412 nct-23.1.20-#8413 nct-23.1.20-#8414 nct-23.1.20-#8431 nct-12.3.2-location
=== settings
H12 = 12.5
D23 = 5
N2923 = 99
=== main
G10 L75 P1
N2
T81501070 Q10001 A0 B2 C131 L200 H12 D23
I7 S1500 F250 J3 K4
P0 R101
P1 R1.5
P20 R-2
N9
T81501070 Q10001 A0 B1 C0 L180 H13 D14
G11
G10 L76 P1
N1 P8 R2
N1 P4 R9
N10 R0
G11
(nothing in the spindle: only the data number has a value)
IF [#8402 EQ #0] THEN #101=7
G0 X#8401 Y#101
T81501070 M6
#8400=10
G0 X#8401 Y[#8402/100000] Z#8403
X#8404 Y#8405 Z#8406
X#8407 Y#8408 Z#8409
X#8410 Y#8411 Z#8412
X#8413 Y#8414 Z#8431
X#8450 Y0 Z0
#8400=20
#102=3
IF [#8402 EQ #0] THEN #102=4
X#102 Y#8401
#8400=10
G0 X0 Y0
G43 Z10 H99
G1 F100 X10
G42 X30 Y0 D99
X60
G40 Y-20
M30
=== truth
rapid 0 7 0
2 815.0107 132
200 7 2
5 17 12
23 1500 250
3 4 1.5
-2 0 0
4 0 0
0 0 0
0 0 22.5
feed 10 0 22.5
feed 30 -5 22.5
feed 60 -5 22.5
feed 60 -20 22.5
=== expect
file 0 main.nc
18: rapid from 0 0 0 to 0 7 0 t0.028
19: event tool tool=81501070 row=2
21: rapid to 2 815.0107 132 t3.232
22: rapid to 200 7 2 t3.232
23: rapid to 5 17 12 t0.78
24: rapid to 23 1500 250 t5.932
25: rapid to 3 4 1.5 t5.984
26: rapid to -2 0 0 t0.02
30: rapid to 4 0 0 t0.024
32: rapid to 0 0 0 t0.016
33: rapid to 0 0 22.5 t0.09
34: feed to 10 0 22.5 F100 t6
35: feed to 30 -5 22.5 F100 t12.3693
36: feed to 60 -5 22.5 F100 t18
37: feed to 60 -20 22.5 F100 t9
38: event end code="M30"
end of program: 37 blocks, 14 motions, 0 errors, 0 warnings
