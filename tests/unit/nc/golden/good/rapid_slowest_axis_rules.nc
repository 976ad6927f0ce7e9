=== about
100 mm at 1000 mm/min on X: 6 s.
proves: nct-6.1-rapid
=== settings
rapid = 1000 6000 6000
=== main
G0 X100 Y50
M30
=== truth
100 50 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 100 50 0 t6
2: event end code="M30"
end of program: 2 blocks, 1 motions, 0 errors, 0 warnings
