=== about
G53.1 with N3212.FOS = 1 turns the axes alone: the linear axes stand, and the coordinates change. From C-20 the table goes
to C-90 and not to C90. The next block is in the plane.
proves: nct-25.11-FOS nct-25.11-SEL nct-25.2-FOS
The ends are worked out with bare matrices, axis by axis.
=== settings
machine = tests/unit/nc/golden/machines/head_table.toml
G54 = 410 280 -420
H1 = 120
gauge1 = 120
tool = 1
N3212.FOS = 1
=== main
G54 G90 G49 G0 X0 Y0 Z300 B0 C-20
G43 Z100 H1
G68.2 X5 Y-5 Z10 I0 J45 K0
G53.1
X10 Y5 Z20
G1 Z2 F300
G69.1 G49 G0 X0 Y0 Z350
B0 C0
M30
=== truth
line 1 -7.4435 -2.2141 180 axis 0 0 1 rotary 0 -20
line 2 -7.4435 -2.2141 100 axis 0 0 1 rotary 0 -20
line 4 -30 199.4544 182.6167 axis 0 -0.7071 0.7071 rotary 45 -90
line 5 15 -15.6066 27.6777 axis 0 -0.7071 0.7071 rotary 45 -90
line 6 15 -2.8787 14.9497 axis 0 -0.7071 0.7071 rotary 45 -90
line 7 -30 199.4544 312.6167 axis 0 -0.7071 0.7071 rotary 45 -90
line 8 0 0 230 axis 0 0 1 rotary 0 0
=== expect
file 0 main.nc
9: event end code="M30"
end of program: 9 blocks, 0 errors, 0 warnings
