=== about
An inner fillet of 5 mm and a cutter of 10: the fillet is left out, the lines meet at (35,10).
proves: nct-15.5.7-AAL
=== settings
D1 = 10
=== main
G0 X-100
G41 G1 X-50 D1 F1000
X40
G3 X45 Y5 R5
G1 Y45
Y90
G40 Y140
M30
=== truth
-100 0 0
-50 10 0
35 10 0
35 45 0
35 90 0
45 140 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: feed to -50 10 0 F1000 t3.0594
main.nc:4:1: warning[nct-cutter-comp]: interference in cutter compensation: this block is left out of the path
    G3 X45 Y5 R5
    ^~~~~~~~~~~~
3: feed to 35 10 0 F1000 t5.1
5: feed to 35 45 0 F1000 t2.1
6: feed to 35 90 0 F1000 t2.7
7: feed to 45 140 0 F1000 t3.0594
8: event end code="M30"
end of program: 8 blocks, 6 motions, 0 errors, 1 warnings
