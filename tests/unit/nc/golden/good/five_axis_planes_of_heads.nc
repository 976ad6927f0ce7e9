=== about
Tilted planes by two vectors and by projection angles on a head-head machine: G53.1 turns the heads and holds the tip,
and the next block is in the plane. From C-45 the second plane is nearer at C32.2279 than at C-147.7721.
proves: nct-25.9-G68.2P3 nct-25.10-G68.2P4 nct-25.11-G53.1 nct-25.11-SEL
The ends are worked out with bare matrices, axis by axis.
=== settings
machine = tests/unit/nc/golden/machines/head_head.toml
G54 = 30 -40 -500
H1 = 120
gauge1 = 120
tool = 1
=== main
G54 G90 G49 G0 X0 Y0 Z300 B0 C0
G43 Z150 H1
G68.2 P3 Q1 X20 Y10 Z5 I1 J1 K0
G68.2 P3 Q2 I0 J-1 K1
G53.1
X5 Y6 Z7
G1 Z-1 F200
G68.2 P4 X0 Y0 Z0 I30 J-20 K15
G53.1
G0 X0 Y0 Z20
G69.1 G49 X0 Y0 Z350
M30
=== truth
line 1 0 0 180 axis 0 0 1
line 2 0 0 150 axis 0 0 1
line 5 0 0 150 axis 0.4082 -0.4082 0.8165 rotary -45 35.2644
line 6 22.9292 14.1419 14.1796 axis 0.4082 -0.4082 0.8165 rotary -45 35.2644
line 7 19.6632 17.4079 7.6476 axis 0.4082 -0.4082 0.8165 rotary -45 35.2644
line 9 19.6632 17.4079 7.6476 axis 0.4769 0.3006 0.826 rotary 32.2279 34.3136
line 10 9.5374 6.0125 16.5193 axis 0.4769 0.3006 0.826 rotary 32.2279 34.3136
line 11 -112.41 -81.7223 282.6267 axis 0.4769 0.3006 0.826 rotary 32.2279 34.3136
=== expect
file 0 main.nc
12: event end code="M30"
end of program: 12 blocks, 0 errors, 0 warnings
