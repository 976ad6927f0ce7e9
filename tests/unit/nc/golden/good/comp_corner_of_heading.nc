=== about
The corner of two lines of the manual's example without the empty block between them: (44.8062,40).
proves: nct-15.5.2-inner
=== settings
D1 = 10
=== main
G0 X-80 Y-100
G42 G1 X-40 Y-50 D1 F1000
G91
N100 X40 Y50
N110 X40 Y50
N130 X90
N140 X50 Y-20
G90 G40 X300
M30
=== truth
-80 -100 0
-32.1913 -56.2470 0
7.8087 -6.2470 0
44.8062 40 0
128.0742 40 0
* * 0
* * 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -80 -100 0 t0.4
2: feed to -32.1913 -56.247 0 F1000 t3.8884
4 N100: feed to 7.8087 -6.247 0 F1000 t3.8419
5 N110: feed to 44.8062 40 0 F1000 t3.5535
6 N130: feed to 128.0742 40 0 F1000 t4.9961
7 N140: feed to 178.0742 20 0 F1000 t3.2311
8: feed to 300 30 0 F1000 t7.3401
9: event end code="M30"
end of program: 9 blocks, 7 motions, 0 errors, 0 warnings
