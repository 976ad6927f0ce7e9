=== about
The dynamic zero goes with the tables while the program stays parallel to the machine; a line with a turn ends on the
table's point.
proves: nct-25.4-G54.2 nct-25.4.1-G10L21
The ends are worked out with bare matrices, axis by axis.
=== settings
machine = tests/unit/nc/golden/machines/table_table.toml
G54 = 420 290 -420
H1 = 120
gauge1 = 120
tool = 1
=== main
G10 L21 P2 X15 Y-20 Z40
G54 G90 G0 X0 Y0 Z300 A0 C0
G43 Z100 H1
G54.2 P2 X0 Y0 Z50 A-40 C75
X10 Y5 Z2
G1 X-10 F400
X10 C15
G54 G0 X0 Y0 Z200
A0 C0
M30
=== truth
line 2 0 0 180 axis 0 0 1 rotary 0 0
line 3 0 0 100 axis 0 0 1 rotary 0 0
line 4 31.0443 8.3183 38.3022 axis 0.6209 0.1664 0.766 rotary -40 75
line 5 7.5297 -8.3352 -1.6818 axis 0.6209 0.1664 0.766 rotary -40 75
line 6 2.3533 10.9833 -1.6818 axis 0.6209 0.1664 0.766 rotary -40 75
line 7 10.9833 2.3533 -1.6818 axis 0.1664 0.6209 0.766 rotary -40 15
line 8 41.5004 172.9069 140.9203 axis 0.1664 0.6209 0.766 rotary -40 15
line 9 0 0 200 axis 0 0 1 rotary 0 0
=== expect
file 0 main.nc
10: event end code="M30"
end of program: 10 blocks, 0 errors, 0 warnings
