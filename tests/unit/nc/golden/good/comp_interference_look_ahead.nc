=== about
A slot of 8 mm, tool radius 5: with one more block of look-ahead (N1404) the control sees both walls and leaves the slot out.
proves: nct-15.5.7-N1404
=== settings
D1 = 5
N1404 = 1
=== main
G0 X-100
G41 G1 X-50 D1 F1000
X40
Y-30
X48
Y0
X90
X120
G40 X150
M30
=== truth
-100 0 0
-50 5 0
43 5 0
90 5 0
120 5 0
150 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: feed to -50 5 0 F1000 t3.015
main.nc:4:1: warning[nct-cutter-comp]: interference in cutter compensation: this block is left out of the path
    Y-30
    ^~~~
3: feed to 43 5 0 F1000 t5.58
7: feed to 90 5 0 F1000 t2.82
8: feed to 120 5 0 F1000 t1.8
9: feed to 150 0 0 F1000 t1.8248
10: event end code="M30"
end of program: 10 blocks, 6 motions, 0 errors, 1 warnings
