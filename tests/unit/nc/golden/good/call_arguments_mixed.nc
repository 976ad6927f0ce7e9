=== about
Digest nct-5, section 11: the two argument types, mixed, and a second N; G and P of the call are stored too.
proves: nct-23.3-args-I nct-23.3-args-II nct-23.3-args-mixed nct-23.3-args-N nct-23.3.1-G65 nct-3-G65
=== main
G65 A2.12 B3.213 J36.9 E129.73 J-12 P2200
/N130 G65 P11 X12.3 Y32.6 N250
G65 P12 A1 B2 C3 I4 J5 K6 I7 J8 K9 I10 J11 K12 I13 J14 K15
G65 P13 D-7 E8 F9 H11 M13 Q17 R18 S19 T20 U21 V22 W23 Z26
M30
=== sub O2200
G0 X#1 Y#2 Z#5
X#8 Y#11
M99
=== sub O0011
G0 X#24 Y#25 Z#14
X#10 Y#16
M99
=== sub O0012
G0 X#1 Y#2 Z#3
X#4 Y#5 Z#6
X#7 Y#8 Z#9
X#10 Y#11 Z#12
X#13 Y#14 Z#15
M99
=== sub O0013
G0 X#7 Y#8 Z#9
X#11 Y#13 Z#17
X#18 Y#19 Z#20
X#21 Y#22 Z#23
X#26
M99
=== truth
rapid 2.12 3.213 36.9
rapid 129.73 -12 36.9
rapid 12.3 32.6 250
rapid 65 11 250
rapid 1 2 3
rapid 4 5 6
rapid 7 8 9
rapid 10 11 12
rapid 13 14 15
rapid -7 8 9
rapid 11 13 17
rapid 18 19 20
rapid 21 22 23
rapid 26 22 23
=== expect
file 0 main.nc
file 1 O2200
1/1 depth 1: rapid from 0 0 0 to 2.12 3.213 36.9 t0.1476
1/2 depth 1: rapid to 129.73 -12 36.9 t0.5104
file 2 O0011
2/1 depth 1: rapid to 12.3 32.6 250 t0.8524
2/2 depth 1: rapid to 65 11 250 t0.2108
file 3 O0012
3/1 depth 1: rapid to 1 2 3 t0.988
3/2 depth 1: rapid to 4 5 6 t0.012
3/3 depth 1: rapid to 7 8 9 t0.012
3/4 depth 1: rapid to 10 11 12 t0.012
3/5 depth 1: rapid to 13 14 15 t0.012
file 4 O0013
4/1 depth 1: rapid to -7 8 9 t0.08
4/2 depth 1: rapid to 11 13 17 t0.072
4/3 depth 1: rapid to 18 19 20 t0.028
4/4 depth 1: rapid to 21 22 23 t0.012
4/5 depth 1: rapid to 26 22 23 t0.02
5: event end code="M30"
end of program: 23 blocks, 14 motions, 0 errors, 0 warnings
