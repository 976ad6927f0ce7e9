=== about
proves: nct-16.2-G51-IJK
=== main
G17
G51 X0 Y0 Z0 I0.5 J0.75 K1.25
G1 X100 ,R10 F100
Y100
X10
G3 X0 Y90 R10
G1 Y0
G50
M30
=== truth
43.75 0 0
50 6.25 0 center 43.75 6.25 0
50 75 0
5 75 0
0 67.5 0 center 4.3014 70.0490 0
0 0 0
=== expect
file 0 main.nc
3: feed from 0 0 0 to 43.75 0 0 F100 t26.25
3: feed arc to 50 6.25 0 center 43.75 6.25 0 normal 0 0 1 sweep 90 F100 t5.8905
4: feed to 50 75 0 F100 t41.25
5: feed to 5 75 0 F100 t27
6: feed arc to 0 67.5 0 center 4.3014 70.049 0 normal 0 0 1 sweep 128.6822 F100 t6.7378
7: feed to 0 0 0 F100 t40.5
9: event end code="M30"
end of program: 9 blocks, 6 motions, 0 errors, 0 warnings
