=== about
Length along the tool of a head-head machine whose axes do not meet: blocks of rotary words alone hold the tip, a
line with a turn ends where it is programmed, and with G49 the numbers are those of the control point.
proves: nct-25.2-G43.1 nct-25.2-G49 nct-25.1-N3219
The ends are worked out with bare matrices, axis by axis.
=== settings
machine = tests/unit/nc/golden/machines/head_head.toml
G54 = 30 -40 -500
H1 = 120
gauge1 = 120
tool = 1
=== main
G54 G90 G49 G0 X0 Y0 Z300 B0 C0
G43.1 Z100 H1
B30 C60
X40 Y-20 Z15
G1 Z-5 F300
G91 X10 B-50
G90 G49 G0 Z400
B0 C0
M30
=== truth
line 1 0 0 180 axis 0 0 1
line 2 0 0 100 axis 0 0 1
line 3 0 0 100 axis 0.25 0.433 0.866 rotary 60 30
line 4 40 -20 15 axis 0.25 0.433 0.866 rotary 60 30
line 5 40 -20 -5 axis 0.25 0.433 0.866 rotary 60 30
line 6 50 -20 -5 axis -0.171 -0.2962 0.9397 rotary 60 -20
line 7 50 -20 292.8628 axis -0.171 -0.2962 0.9397 rotary 60 -20
line 8 -23.1249 -104.3355 280 axis 0 0 1 rotary 0 0
=== expect
file 0 main.nc
9: event end code="M30"
end of program: 9 blocks, 0 errors, 0 warnings
