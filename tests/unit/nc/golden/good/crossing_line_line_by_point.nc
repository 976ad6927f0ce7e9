=== about
The first line by a point that it passes instead of its direction: the same corner.
proves: nct-17.3.1-LL
=== main
G17 G90 G41 D0
G0 X90 Y10
N10 G1 X50 Y33.094 F100
N20 X10 Y20 ,A225
G0 X0 Y20
G40 X0 Y30
M30
=== truth
90 10 0
32.9423 42.9423 0
10 20 0
0 20 0
0 30 0
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 90 10 0 t0.36
3 N10: feed to 32.9423 42.9423 0 F100 t39.5307
4 N20: feed to 10 20 0 F100 t19.4672
5: rapid to 0 20 0 t0.04
6: rapid to 0 30 0 t0.04
7: event end code="M30"
end of program: 7 blocks, 5 motions, 0 errors, 0 warnings
