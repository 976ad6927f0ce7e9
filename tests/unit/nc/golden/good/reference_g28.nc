=== about
proves: nct-3-G28 nct-9.1-G28
=== settings
reference1 = 500 400 300
=== main
G90 G28 X100 Y50
G0 X20 Y50
G91 G28 X100 Y50
M30
=== truth
100 50 0
500 400 0
20 50 0
120 100 0
500 400 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 100 50 0 t0.4
1: rapid to 500 400 0 t1.6
2: rapid to 20 50 0 t1.92
3: rapid to 120 100 0 t0.4
3: rapid to 500 400 0 t1.52
4: event end code="M30"
end of program: 4 blocks, 5 motions, 0 errors, 0 warnings
