=== about
Digest nct-5, 23.2.11: 27 passes.
proves: nct-23.2.11-WHILE
=== main
#1=0
#2=10
G0 X#2
Z[#1+1]
WHILE[#1GT-5.39] DO1
#1=#1-0.2
#2=-#2
G1 Z#1 F100
X#2 F500
END1
G0 Z20
M30
=== truth
rapid 10 0 0
rapid 10 0 1
feed 10 0 -0.2000 F 100
feed -10 0 -0.2000 F 500
feed -10 0 -0.4000 F 100
feed 10 0 -0.4000 F 500
feed 10 0 -0.6000 F 100
feed -10 0 -0.6000 F 500
feed -10 0 -0.8000 F 100
feed 10 0 -0.8000 F 500
feed 10 0 -1.0000 F 100
feed -10 0 -1.0000 F 500
feed -10 0 -1.2000 F 100
feed 10 0 -1.2000 F 500
feed 10 0 -1.4000 F 100
feed -10 0 -1.4000 F 500
feed -10 0 -1.6000 F 100
feed 10 0 -1.6000 F 500
feed 10 0 -1.8000 F 100
feed -10 0 -1.8000 F 500
feed -10 0 -2.0000 F 100
feed 10 0 -2.0000 F 500
feed 10 0 -2.2000 F 100
feed -10 0 -2.2000 F 500
feed -10 0 -2.4000 F 100
feed 10 0 -2.4000 F 500
feed 10 0 -2.6000 F 100
feed -10 0 -2.6000 F 500
feed -10 0 -2.8000 F 100
feed 10 0 -2.8000 F 500
feed 10 0 -3.0000 F 100
feed -10 0 -3.0000 F 500
feed -10 0 -3.2000 F 100
feed 10 0 -3.2000 F 500
feed 10 0 -3.4000 F 100
feed -10 0 -3.4000 F 500
feed -10 0 -3.6000 F 100
feed 10 0 -3.6000 F 500
feed 10 0 -3.8000 F 100
feed -10 0 -3.8000 F 500
feed -10 0 -4.0000 F 100
feed 10 0 -4.0000 F 500
feed 10 0 -4.2000 F 100
feed -10 0 -4.2000 F 500
feed -10 0 -4.4000 F 100
feed 10 0 -4.4000 F 500
feed 10 0 -4.6000 F 100
feed -10 0 -4.6000 F 500
feed -10 0 -4.8000 F 100
feed 10 0 -4.8000 F 500
feed 10 0 -5.0000 F 100
feed -10 0 -5.0000 F 500
feed -10 0 -5.2000 F 100
feed 10 0 -5.2000 F 500
feed 10 0 -5.4000 F 100
feed -10 0 -5.4000 F 500
rapid -10 0 20
=== expect
file 0 main.nc
3: rapid from 0 0 0 to 10 0 0 t0.04
4: rapid to 10 0 1 t0.004
8: feed to 10 0 -0.2 F100 t0.72
9: feed to -10 0 -0.2 F500 t2.4
8: feed to -10 0 -0.4 F100 t0.12
9: feed to 10 0 -0.4 F500 t2.4
8: feed to 10 0 -0.6 F100 t0.12
9: feed to -10 0 -0.6 F500 t2.4
8: feed to -10 0 -0.8 F100 t0.12
9: feed to 10 0 -0.8 F500 t2.4
8: feed to 10 0 -1 F100 t0.12
9: feed to -10 0 -1 F500 t2.4
8: feed to -10 0 -1.2 F100 t0.12
9: feed to 10 0 -1.2 F500 t2.4
8: feed to 10 0 -1.4 F100 t0.12
9: feed to -10 0 -1.4 F500 t2.4
8: feed to -10 0 -1.6 F100 t0.12
9: feed to 10 0 -1.6 F500 t2.4
8: feed to 10 0 -1.8 F100 t0.12
9: feed to -10 0 -1.8 F500 t2.4
8: feed to -10 0 -2 F100 t0.12
9: feed to 10 0 -2 F500 t2.4
8: feed to 10 0 -2.2 F100 t0.12
9: feed to -10 0 -2.2 F500 t2.4
8: feed to -10 0 -2.4 F100 t0.12
9: feed to 10 0 -2.4 F500 t2.4
8: feed to 10 0 -2.6 F100 t0.12
9: feed to -10 0 -2.6 F500 t2.4
8: feed to -10 0 -2.8 F100 t0.12
9: feed to 10 0 -2.8 F500 t2.4
8: feed to 10 0 -3 F100 t0.12
9: feed to -10 0 -3 F500 t2.4
8: feed to -10 0 -3.2 F100 t0.12
9: feed to 10 0 -3.2 F500 t2.4
8: feed to 10 0 -3.4 F100 t0.12
9: feed to -10 0 -3.4 F500 t2.4
8: feed to -10 0 -3.6 F100 t0.12
9: feed to 10 0 -3.6 F500 t2.4
8: feed to 10 0 -3.8 F100 t0.12
9: feed to -10 0 -3.8 F500 t2.4
8: feed to -10 0 -4 F100 t0.12
9: feed to 10 0 -4 F500 t2.4
8: feed to 10 0 -4.2 F100 t0.12
9: feed to -10 0 -4.2 F500 t2.4
8: feed to -10 0 -4.4 F100 t0.12
9: feed to 10 0 -4.4 F500 t2.4
8: feed to 10 0 -4.6 F100 t0.12
9: feed to -10 0 -4.6 F500 t2.4
8: feed to -10 0 -4.8 F100 t0.12
9: feed to 10 0 -4.8 F500 t2.4
8: feed to 10 0 -5 F100 t0.12
9: feed to -10 0 -5 F500 t2.4
8: feed to -10 0 -5.2 F100 t0.12
9: feed to 10 0 -5.2 F500 t2.4
8: feed to 10 0 -5.4 F100 t0.12
9: feed to -10 0 -5.4 F500 t2.4
11: rapid to -10 0 20 t0.1016
12: event end code="M30"
end of program: 169 blocks, 57 motions, 0 errors, 0 warnings
