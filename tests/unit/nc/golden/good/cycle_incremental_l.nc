=== about
proves: nct-18-L nct-18.1.5-G81
=== main
N1 G90 G17 G0 X0 Y0 Z100 M3
N2 G91 G81 X100 Z-40 R-97 F50 L5
M30
=== truth
0 0 100
100 0 100
100 0 3
100 0 -37
100 0 100
200 0 100
200 0 3
200 0 -37
200 0 100
300 0 100
300 0 3
300 0 -37
300 0 100
400 0 100
400 0 3
400 0 -37
400 0 100
500 0 100
500 0 3
500 0 -37
500 0 100
=== expect
file 0 main.nc
1 N1: event spindle rpm=0 direction="cw"
1 N1: rapid from 0 0 0 to 0 0 100 t0.4
2 N2: rapid to 100 0 100 t0.4
2 N2: rapid to 100 0 3 t0.388
2 N2: feed to 100 0 -37 F50 t48
2 N2: rapid to 100 0 100 t0.548
2 N2: rapid to 200 0 100 t0.4
2 N2: rapid to 200 0 3 t0.388
2 N2: feed to 200 0 -37 F50 t48
2 N2: rapid to 200 0 100 t0.548
2 N2: rapid to 300 0 100 t0.4
2 N2: rapid to 300 0 3 t0.388
2 N2: feed to 300 0 -37 F50 t48
2 N2: rapid to 300 0 100 t0.548
2 N2: rapid to 400 0 100 t0.4
2 N2: rapid to 400 0 3 t0.388
2 N2: feed to 400 0 -37 F50 t48
2 N2: rapid to 400 0 100 t0.548
2 N2: rapid to 500 0 100 t0.4
2 N2: rapid to 500 0 3 t0.388
2 N2: feed to 500 0 -37 F50 t48
2 N2: rapid to 500 0 100 t0.548
3: event end code="M30"
end of program: 3 blocks, 21 motions, 0 errors, 0 warnings
