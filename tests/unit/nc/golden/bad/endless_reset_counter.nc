=== about
A loop whose counter starts again with nothing else changed, through a macro and an inner loop.
Truth: the loop is lines 2 to 10.
=== main
#1=0
N10 #1=#1+1
G65 P2 A#1
WHILE[#2 LT 3] DO1
#2=#2+1
END1
#2=0
IF[#1 LT 4] GOTO 10
#1=0
GOTO 10
M30
=== sub O0002.nc
#4=#1*2
#5=#4+1
M99
=== says
an endless loop: the program comes back to lines 2 to 10
0 motions, 1 errors
=== expect
file 0 main.nc
file 1 O0002.nc
main.nc:4:1: error[nct-endless-loop]: an endless loop: the program comes back to lines 2 to 10 with nothing changed
    WHILE[#2 LT 3] DO1
    ^~~~~~~~~~~~~~~~~~
    note: #2 = 1
block limit: 507 blocks, 0 motions, 1 errors, 0 warnings
