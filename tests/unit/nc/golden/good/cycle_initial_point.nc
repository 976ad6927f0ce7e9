=== about
proves: nct-18-init nct-18.1.5-G81
=== main
N1 G17 G90 G0 Z200
N2 G81 X0 Y0 Z50 R150 F100
N3 X100 Y30 Z80
M30
=== truth
0 0 200
0 0 150
0 0 50
0 0 200
100 30 200
100 30 150
100 30 80
100 30 200
=== expect
file 0 main.nc
1 N1: rapid from 0 0 0 to 0 0 200 t0.8
2 N2: rapid to 0 0 150 t0.2
2 N2: feed to 0 0 50 F100 t60
2 N2: rapid to 0 0 200 t0.6
3 N3: rapid to 100 30 200 t0.4
3 N3: rapid to 100 30 150 t0.2
3 N3: feed to 100 30 80 F100 t42
3 N3: rapid to 100 30 200 t0.48
4: event end code="M30"
end of program: 4 blocks, 8 motions, 0 errors, 0 warnings
