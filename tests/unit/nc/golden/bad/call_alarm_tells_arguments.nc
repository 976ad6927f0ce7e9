=== main
G65 P11 A5 X-2.5
M30
=== sub O0011
G65 P12 B#1
M99
=== sub O0012
#3=0
G0 X[#2/#3]
M99
=== says
O0012:2:4: error[nct-2093]
=== expect
file 0 main.nc
file 1 O0011
file 2 O0012
O0012:2:4: error[nct-2093]: division by 0
    G0 X[#2/#3]
       ^~~~~~~
    note: called from O0011:1 by G65 #2=5 #10=65 #16=12
    note: called from main.nc:1 by G65 #1=5 #10=65 #16=11 #24=-2.5
    note: #2 = 5
    note: #3 = 0
alarm: 4 blocks, 0 motions, 1 errors, 0 warnings
