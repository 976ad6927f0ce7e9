=== about
proves: nct-18-axis nct-18-init
=== settings
axis = W 4 linear parallel Z
=== main
N1 G17 G90 G0 Z200 W50
N2 G81 X0 Y0 Z50 R150 F100
N3 X100 Y30 W20 R25
G80
M30
=== truth
0 0 250 rapid
0 0 200 rapid
0 0 100 feed
0 0 250 rapid
100 30 250 rapid
100 30 225 rapid
100 30 220 feed
100 30 250 rapid
=== expect
file 0 main.nc
1 N1: rapid from 0 0 0 to 0 0 250 t0.8
2 N2: rapid to 0 0 200 t0.2
2 N2: feed to 0 0 100 F100 t60
2 N2: rapid to 0 0 250 t0.6
3 N3: rapid to 100 30 250 t0.4
3 N3: rapid to 100 30 225 t0.1
3 N3: feed to 100 30 220 F100 t3
3 N3: rapid to 100 30 250 t0.12
5: event end code="M30"
end of program: 5 blocks, 8 motions, 0 errors, 0 warnings
