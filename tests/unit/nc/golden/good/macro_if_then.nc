=== about
Digest nct-5, 23.2.10.
proves: nct-23.2.10-IF-THEN
=== main
#100=0
#101=0
#1=20
IF[#1EQ20] THEN#100=3.15
IF[#100GT3.15] #101=5
G0 X#100 Y#101
IF[#101EQ0] THEN G1 X10 F500
IF[#101EQ0] IF[#1EQ20] X11 (nested)
N50 IF[#101NE0] M30
if[#1eq20]then#102=12
X#102
M30
=== truth
rapid 3.15 0 0
feed 10 0 0
feed 11 0 0
feed 12 0 0
=== expect
file 0 main.nc
6: rapid from 0 0 0 to 3.15 0 0 t0.0126
7: feed to 10 0 0 F500 t0.822
8: feed to 11 0 0 F500 t0.12
11: feed to 12 0 0 F500 t0.12
12: event end code="M30"
end of program: 12 blocks, 4 motions, 0 errors, 0 warnings
