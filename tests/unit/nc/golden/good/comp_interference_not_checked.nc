=== about
A step of 3 mm between two lines, tool radius 10: without the check the tool cuts in, with it it is alarm 2049.
proves: nct-15.5.7-IEN
=== settings
D1 = 10
N1403.IEN = 0
=== main
G0 X-100
G41 G1 X-50 D1 F1000
X40
Y3
X-50
G40 X-90
M30
=== truth
-100 0 0
-50 10 0
30 10 0
30 -7 0
-50 -7 0
-90 3 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: feed to -50 10 0 F1000 t3.0594
3: feed to 30 10 0 F1000 t4.8
4: feed to 30 -7 0 F1000 t1.02
5: feed to -50 -7 0 F1000 t4.8
6: feed to -90 3 0 F1000 t2.4739
7: event end code="M30"
end of program: 7 blocks, 6 motions, 0 errors, 0 warnings
