=== about
Positions by variable (manual 23.1.15, 25.19): tip at Z-5 with a length of 100 and a zero point of 20. #5003 is the tip,
#5023 the machine position, #5043 the position with the length; #5083 the length in force. Low, high numbers and
names are the same. Inch values in G20, degrees as they are.
proves: nct-23.1.15-absio nct-23.1.15-absmt nct-23.1.15-absot nct-23.1.16-tofs nct-23.1.17-dist
nct-23.1.17-sverr nct-23.1.17-mirtp nct-23.1.5-notation
=== settings
G54 = 0 0 20
H1 = 100
axis = C 6 rotary carries nothing
=== main
G43 G0 X3 Y4 Z-5 C30 H1
#100=#5003
#101=#5023
#102=#5043
#103=#5083
#104=#5006
G53 X#100 Y#101 Z#102
X#103 Y#104 Z#5186
X#_ABSIO[1] Y#_ABSMT[1] Z#100151
X#5101 Y#_SVERR[2] Z#_MIRTP[3]
X12.7 Y2.54 Z0
G20
#105=#5001
#106=#_ABSOT[2]
#107=#100203
#108=#100006
G21
X#105 Y#106 Z#107
X#108 Y#_TOFS[1] Z#_DIST[3]
M30
=== truth
3 4 95
-5 115 75
100 30 100
100 100 100
0 0 100
12.7 2.54 100
0.5 0.1 103.93700787
30 0 100
=== expect
file 0 main.nc
main.nc:1:18: note[nct-rotary-told]: axis C turns nothing that the job describes: its position is told, the path does not follow it
    G43 G0 X3 Y4 Z-5 C30 H1
                     ^~~
1: rapid from 0 0 0 to 3 4 95 C 0 to 30 t0.38
main.nc:7:1: warning[nct-machine-zero]: G53: the job gives no reference point ([machine] reference_points), so machine zero is only as good as its work offsets ([offsets.work])
    G53 X#100 Y#101 Z#102
    ^~~~~~~~~~~~~~~~~~~~~
7: rapid to -5 115 75 C 30 to 30 t0.444
8: rapid to 100 30 100 C 30 to 30 t0.42
9: rapid to 100 100 100 C 30 to 30 t0.28
10: rapid to 0 0 100 C 30 to 30 t0.4
11: rapid to 12.7 2.54 100 C 30 to 30 t0.0508
18: rapid to 0.5 0.1 103.937 C 30 to 30 t0.0488
19: rapid to 30 0 100 C 30 to 30 t0.118
20: event end code="M30"
end of program: 20 blocks, 8 motions, 0 errors, 1 warnings
