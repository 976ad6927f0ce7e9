=== about
Locals of each level, kept and restored; a subprogram shares those of its caller.
proves: nct-23.3-levels nct-23.1.3-local
=== main
#24=7
#1=1
G65 P100 X20 Y30
G0 X#24 Y#25 (the caller's own again: Y is vacant)
X#500 Y#501
X#502 Y#503
#1=0
G65 P200 A1
X#1 Y#510
M98 P300
X#1
M30
=== sub O0100
IF[#1EQ#0] #500=1
#501=#24+#25
#502=#10
#503=#16
#24=99
M99
=== sub O0200
(fifteen levels below)
IF[#1EQ15] GOTO10
G65 P200 A[#1+1]
IF[#1EQ#2] GOTO20
M99
N10 #510=#1
#2=#1
N20 M99
=== sub O0300
#1=33
M99
=== truth
rapid 7 0 0
rapid 1 50 0
rapid 65 100 0
rapid 0 15 0
rapid 33 15 0
=== expect
file 0 main.nc
file 1 O0100
4: rapid from 0 0 0 to 7 0 0 t0.028
5: rapid to 1 50 0 t0.2
6: rapid to 65 100 0 t0.256
file 2 O0200
9: rapid to 0 15 0 t0.34
file 3 O0300
11: rapid to 33 15 0 t0.132
12: event end code="M30"
end of program: 80 blocks, 5 motions, 0 errors, 0 warnings
