=== about
Sixteen calls may be open.
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
G0 X1
M99
=== truth
rapid 1 0 0
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
16/1 depth 16: rapid from 0 0 0 to 1 0 0 t0.004
2: event end code="M30"
end of program: 34 blocks, 1 motions, 0 errors, 0 warnings
