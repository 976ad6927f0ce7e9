=== about
Length along the head, zero that goes with the table, a turn of space in it.
proves: nct-25.2-G43.1 nct-25.3-G68.1 nct-25.3-G69.1 nct-25.4-G54.2
The ends are worked out with bare matrices, axis by axis.
=== settings
machine = tests/unit/nc/golden/machines/head_table.toml
G54 = 410 280 -420
H1 = 120
gauge1 = 120
tool = 1
=== main
G10 L21 P1 X10 Y-20 Z80
G54 G90 G49 G0 X0 Y0 Z300 B0 C0
B-50
G43.1 X0 Y0 Z100 H1
G54.2 P1
C70
G68.1 X5 Y0 Z10 I0 J1 K0 R-50
X10 Y5 Z20
G1 Z0 F300
X-10
G69.1
G0 X0 Y0 Z150
G54 G49 X0 Y0 Z400
B0 C0
M30
=== truth
line 2 0 0 180 axis 0 0 1 rotary 0 0
line 3 208.6181 0 272.6171 axis -0.766 0 0.6428 rotary -50 0
line 4 0 0 100 axis -0.766 0 0.6428 rotary -50 0
line 6 0 0 100 axis -0.262 -0.7198 0.6428 rotary -50 70
line 8 -6.03 -1.9481 30.5162 axis -0.262 -0.7198 0.6428 rotary -50 70
line 9 -0.7899 12.4488 17.6604 axis -0.262 -0.7198 0.6428 rotary -50 70
line 10 -5.1868 0.3683 2.3396 axis -0.262 -0.7198 0.6428 rotary -50 70
line 12 0 0 150 axis -0.262 -0.7198 0.6428 rotary -50 70
line 13 83.5656 218.5934 372.6171 axis -0.262 -0.7198 0.6428 rotary -50 70
line 14 0 0 280 axis 0 0 1 rotary 0 0
=== expect
file 0 main.nc
15: event end code="M30"
end of program: 15 blocks, 0 errors, 0 warnings
