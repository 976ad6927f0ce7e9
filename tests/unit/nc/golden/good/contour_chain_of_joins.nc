=== about
Functions between two blocks of the contour wait for the corner.
proves: nct-17.1-C nct-17.1-R
=== main
G90 G0 X120 Y0
G17 G1 Y40 ,C10 F100
X60 ,R22
M8
G3 X20 Y80 R40 ,C10
G1 Y110
M30
=== truth
120 0 0
120 30 0
110 40 0
77.9655 40 0
57.3971 54.1935 0 center 77.9655 62 0
29.9216 78.75 0 center 20 40 0
20 90 0
20 110 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 120 0 0 t0.48
2: feed to 120 30 0 F100 t18
2: feed to 110 40 0 F100 t8.4853
3: feed to 77.9655 40 0 F100 t19.2207
3: feed arc to 57.3971 54.1935 0 center 77.9655 62 0 normal 0 0 1 sweep -69.2164 F100 t15.9463
4: event coolant code="M8" on=true
5: feed arc to 29.9216 78.75 0 center 20 40 0 normal 0 0 1 sweep 54.8549 F100 t22.9776
5: feed to 20 90 0 F100 t9
6: feed to 20 110 0 F100 t12
7: event end code="M30"
end of program: 7 blocks, 8 motions, 0 errors, 0 warnings
