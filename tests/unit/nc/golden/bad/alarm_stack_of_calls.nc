=== about
An alarm deep inside: number and text, place, the line, five calls with their kinds and arguments, the values of the words and of the
variables in them.
Truth: (7, 0) and (8, 6) about (9, 0): radii 2 and sqrt 37.
=== settings
N1704 = 101
=== main
G65 P11 A1 B[2*3]
M30
=== sub O0011
G66 P12 C#2
G0 X#1
M99
=== sub O0012
M98 P13
M99
=== sub O0013
#33=4
N70 G101 X7 Y#3
M99
=== sub SystemMacros/Channel1/O9010.nct
N10 G1 X#24 F100
N20 G2 X[#24+1] Y#25 I[#24-#25+1] J#26
M99
=== truth
rapid 1 0 0
feed 7 0 0 F 100 t 3.6
=== says
O9010.nct:2:1: error[nct-2012]: circle radius difference error: 4.08276 mm
O0013:2 by G101 (system call) #10=101 #24=7 #25=6
O0012:1 by M98
O0011:2 by G66 #3=6
main.nc:1 by G65 #1=1 #2=6
X[#24+1] = 8
Y#25 = 6
I[#24-#25+1] = 2
=== expect
file 0 main.nc
file 1 O0011
file 2 O0012
1/2 depth 1: rapid from 0 0 0 to 1 0 0 t0.004
file 3 O0013
file 4 SystemMacros/Channel1/O9010.nct
4/1 N10 depth 4: feed to 7 0 0 F100 t3.6
SystemMacros/Channel1/O9010.nct:2:1: error[nct-2012]: circle radius difference error: 4.08276 mm between start and end radius, 2 allowed
    N20 G2 X[#24+1] Y#25 I[#24-#25+1] J#26
    ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
    note: called from O0013:2 by G101 (system call) #10=101 #24=7 #25=6
    note: called from O0012:1 by M98
    note: called from O0011:2 by G66 #3=6 #10=66 #16=12
    note: called from main.nc:1 by G65 #1=1 #2=6 #10=65 #16=11
    note: X[#24+1] = 8
    note: Y#25 = 6
    note: I[#24-#25+1] = 2
alarm: 8 blocks, 2 motions, 1 errors, 0 warnings
