=== about
proves: nct-23.3-depth
=== main
G65 P100
M30
=== sub O0100
G65 P101
M99
=== sub O0101
G65 P102
M99
=== sub O0102
G65 P103
M99
=== sub O0103
G65 P104
M99
=== sub O0104
G65 P105
M99
=== sub O0105
G65 P106
M99
=== sub O0106
G65 P107
M99
=== sub O0107
G65 P108
M99
=== sub O0108
G65 P109
M99
=== sub O0109
G65 P110
M99
=== sub O0110
G65 P111
M99
=== sub O0111
G65 P112
M99
=== sub O0112
G65 P113
M99
=== sub O0113
G65 P114
M99
=== sub O0114
G65 P115
M99
=== sub O0115
G65 P116
M99
=== sub O0116
G0 X1
M99
=== says
O0115:1:1: error[nct-nesting]
=== expect
file 0 main.nc
file 1 O0100
file 2 O0101
file 3 O0102
file 4 O0103
file 5 O0104
file 6 O0105
file 7 O0106
file 8 O0107
file 9 O0108
file 10 O0109
file 11 O0110
file 12 O0111
file 13 O0112
file 14 O0113
file 15 O0114
file 16 O0115
file 17 O0116
O0115:1:1: error[nct-nesting]: subprogram calls are nested deeper than 16
    G65 P116
    ^~~~~~~~
    note: called from O0114:1 by G65 #10=65 #16=115
    note: called from O0113:1 by G65 #10=65 #16=114
    note: called from O0112:1 by G65 #10=65 #16=113
    note: called from O0111:1 by G65 #10=65 #16=112
    note: called from O0110:1 by G65 #10=65 #16=111
    note: called from O0109:1 by G65 #10=65 #16=110
    note: called from O0108:1 by G65 #10=65 #16=109
    note: called from O0107:1 by G65 #10=65 #16=108
    note: called from O0106:1 by G65 #10=65 #16=107
    note: called from O0105:1 by G65 #10=65 #16=106
    note: called from O0104:1 by G65 #10=65 #16=105
    note: called from O0103:1 by G65 #10=65 #16=104
    note: called from O0102:1 by G65 #10=65 #16=103
    note: called from O0101:1 by G65 #10=65 #16=102
    note: called from O0100:1 by G65 #10=65 #16=101
    note: called from main.nc:1 by G65 #10=65 #16=100
alarm: 17 blocks, 0 motions, 1 errors, 0 warnings
