=== about
A tilted plane on a table-table machine, A left-handed and C right-handed: line, arc and cycle in it. From C20 the pair
A-30 C90 is nearer than A30 C-90. With G69.1 and G49 the numbers are machine-parallel again.
proves: nct-25.6-G68.2 nct-25.6-G69.1 nct-25.11-G53.1 nct-25.1-N3212-RD
The ends are worked out with bare matrices, axis by axis.
=== settings
machine = tests/unit/nc/golden/machines/table_table.toml
G54 = 420 290 -420
H1 = 120
gauge1 = 120
tool = 1
=== main
G54 G90 G0 X0 Y0 Z300 A0 C20
G43 Z100 H1
G68.2 X10 Y-5 Z20 I90 J30 K0
G53.1
X0 Y0 Z10
G1 Z-2 F200
G3 X20 Y0 I10 J0
G0 Z50
G81 X5 Y5 Z-3 R2 F100
G80
G69.1 G49 G0 Z250
A0 C0
M30
=== truth
line 1 -7.745 -3.9242 180 axis 0 0 1 rotary 0 20
line 2 -7.745 -3.9242 100 axis 0 0 1 rotary 0 20
line 4 -7.745 -3.9242 100 axis 0.5 0 0.866 rotary -30 90
line 5 15 -5 28.6603 axis 0.5 0 0.866 rotary -30 90
line 6 9 -5 18.2679 axis 0.5 0 0.866 rotary -30 90
line 7 9 15 18.2679 center 9 5 18.2679 sweep 180 axis 0.5 0 0.866 rotary -30 90
line 8 35 15 63.3013 axis 0.5 0 0.866 rotary -30 90
line 9 30.6699 0 65.8013 axis 0.5 0 0.866 rotary -30 90
line 11 58.6186 0 114.2099 axis 0.5 0 0.866 rotary -30 90
line 12 5 -14.6891 130 axis 0 0 1 rotary 0 0
=== expect
file 0 main.nc
13: event end code="M30"
end of program: 13 blocks, 0 errors, 0 warnings
