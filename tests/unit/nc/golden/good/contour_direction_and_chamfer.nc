=== about
proves: nct-17.2-A
=== main
G17 G1 X30 F100
X60 ,A30 ,C5
Y50
M30
=== truth
30 0 0
55.6699 14.8205 0
60 22.3205 0
60 50 0
=== expect
file 0 main.nc
1: feed from 0 0 0 to 30 0 0 F100 t18
2: feed to 55.6699 14.8205 0 F100 t17.7846
2: feed to 60 22.3205 0 F100 t5.1962
3: feed to 60 50 0 F100 t16.6077
4: event end code="M30"
end of program: 4 blocks, 4 motions, 0 errors, 0 warnings
