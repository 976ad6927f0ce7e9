=== about
Digest nct-5, section 14: a part turned from one plane into another.
proves: nct-23.3.3-G66.1 nct-3-G66.1
=== main
G66.1 P400
G18 X0 Y0 Z-5 (first argument list)
G1 X40 Y30 F1000
N7
G3 X0 Y50 I-40 J-30
#100=1 (macro blocks call nothing)
G1 Y0
G67
G0 X1
M30
=== sub O0400
IF[#10EQ66.1] GOTO10
G#10 X-#24 Y#26 Z#25 I-#4 K#5 R#18 F#9
N10 M99
=== truth
rapid 0 -5 0
feed -40 -5 30
feed 0 -5 50 center 0 -5 0 sweep 53.1301 F 1000 t 2.7819
feed 0 -5 0
rapid 1 -5 0
=== expect
file 0 main.nc
file 1 O0400
1/2 depth 1: rapid from 0 0 0 to 0 -5 0 t0.02
1/2 depth 1: feed to -40 -5 30 F1000 t3
1/2 depth 1: feed arc to 0 -5 50 center 0 -5 0 normal 0 1 0 sweep 53.1301 F1000 t2.7819
1/2 depth 1: feed to 0 -5 0 F1000 t3
9: rapid to 1 -5 0 t0.004
10: event end code="M30"
end of program: 23 blocks, 5 motions, 0 errors, 0 warnings
