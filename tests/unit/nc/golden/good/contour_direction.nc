=== about
proves: nct-1.1-commaA nct-17.2-A
=== main
G17 G90 G0 X57.735 Y0
G1 G91 F100
X100 ,A30
Y100 ,A120
X-100 ,A210
Y-100 ,A300
G0 X10 ,A405
M30
=== truth
57.735 0 0
157.735 57.735 0
100 157.735 0
0 100 0
57.735 0 0
67.735 10 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 57.735 0 0 t0.2309
3: feed to 157.735 57.735 0 F100 t69.282
4: feed to 100 157.735 0 F100 t69.282
5: feed to 0 100 0 F100 t69.282
6: feed to 57.735 0 0 F100 t69.282
7: rapid to 67.735 10 0 t0.04
8: event end code="M30"
end of program: 8 blocks, 6 motions, 0 errors, 0 warnings
