=== about
Inches: the stored position is in the unit in force.
proves: nct-21.1-G31
=== settings
probe = plane 1 0 0 25.4
=== main
G20 G31 X2 F10
G0 Y#5061
M30
=== truth
probe 25.4 0 0 F 254
25.4 25.4 0
=== expect
file 0 main.nc
1: probe from 0 0 0 to 25.4 0 0 F254 t6
1: event probe contact=true
2: rapid to 25.4 25.4 0 t0.1016
3: event end code="M30"
end of program: 3 blocks, 2 motions, 0 errors, 0 warnings
