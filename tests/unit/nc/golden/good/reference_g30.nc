=== about
proves: nct-3-G30 nct-9.2-G30
=== settings
reference3 = 3 3 3
reference4 = 4 4 4
=== main
G90 G30 X100 Y50 P3
G0 X20 Y50
G91 G30 X100 Y50 P4
M30
=== truth
100 50 0
3 3 0
20 50 0
120 100 0
4 4 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 100 50 0 t0.4
1: rapid to 3 3 0 t0.388
2: rapid to 20 50 0 t0.188
3: rapid to 120 100 0 t0.4
3: rapid to 4 4 0 t0.464
4: event end code="M30"
end of program: 4 blocks, 5 motions, 0 errors, 0 warnings
