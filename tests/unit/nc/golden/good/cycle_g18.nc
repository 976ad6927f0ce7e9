=== about
proves: nct-18-axis nct-18.1.5-G81 nct-3-G18
=== main
G18 G0 X0 Y20 Z0
G99 G81 X5 Z7 Y-10 R2 F100
M30
=== truth
0 20 0
5 20 7
5 2 7
feed 5 -10 7
rapid 5 2 7
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 20 0 t0.08
2: rapid to 5 20 7 t0.028
2: rapid to 5 2 7 t0.072
2: feed to 5 -10 7 F100 t7.2
2: rapid to 5 2 7 t0.048
3: event end code="M30"
end of program: 3 blocks, 5 motions, 0 errors, 0 warnings
