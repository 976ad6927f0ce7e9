=== about
proves: nct-17.2-A nct-18-hole
=== main
G17 G90 G0 X0 Y0 Z10
G81 G91 X100 ,A30 R-8 Z-25 F100 L2
G80
M30
=== truth
0 0 10
100 57.735 10
100 57.735 2
100 57.735 -23
100 57.735 10
200 115.4701 10
200 115.4701 2
200 115.4701 -23
200 115.4701 10
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 10 t0.04
2: rapid to 100 57.735 10 t0.4
2: rapid to 100 57.735 2 t0.032
2: feed to 100 57.735 -23 F100 t15
2: rapid to 100 57.735 10 t0.132
2: rapid to 200 115.4701 10 t0.4
2: rapid to 200 115.4701 2 t0.032
2: feed to 200 115.4701 -23 F100 t15
2: rapid to 200 115.4701 10 t0.132
4: event end code="M30"
end of program: 4 blocks, 9 motions, 0 errors, 0 warnings
