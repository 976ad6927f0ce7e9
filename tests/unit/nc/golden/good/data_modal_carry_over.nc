=== about
proves: nct-4.2-G1 nct-1.1-N
=== main
N15 G90 G1 X20 Y30 F180
N16 X30
N17 Y100
N18 G91 G01 Z100 F120
M30
=== truth
20 30 0 F 180
30 30 0 F 180
30 100 0 F 180
30 100 100 F 120
=== expect
file 0 main.nc
1 N15: feed from 0 0 0 to 20 30 0 F180 t12.0185
2 N16: feed to 30 30 0 F180 t3.3333
3 N17: feed to 30 100 0 F180 t23.3333
4 N18: feed to 30 100 100 F120 t50
5: event end code="M30"
end of program: 5 blocks, 4 motions, 0 errors, 0 warnings
