=== about
A small inner arc between two lines that fall away: its corner (7.6603,6.7321) joins them.
proves: nct-15.5.7-AAL
=== settings
D1 = 10
=== main
G0 X-100
G41 G1 X-50 D1 F1000
X0
G3 X10.9282032 Y-2.9282032 I6.9282032 J4
G1 X62.8897274 Y-32.9282032
X88.8704896 Y-47.9282032
G40 X140
M30
=== truth
-100 0 0
-50 10 0
5.7735 10 0
7.6603 6.7321 0
10.9282 8.6188 0
* * 0
* * 0
* * 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: feed to -50 10 0 F1000 t3.0594
main.nc:4:1: warning[nct-cutter-comp]: interference in cutter compensation: this block is left out of the path
    G3 X10.9282032 Y-2.9282032 I6.9282032 J4
    ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
3: feed to 5.7735 10 0 F1000 t3.3464
3: feed to 7.6603 6.7321 0 F1000 t0.2264
3: feed to 10.9282 8.6188 0 F1000 t0.2264
5: feed to 67.8897 -24.2679 0 F1000 t3.9464
6: feed to 93.8705 -39.2679 0 F1000 t1.8
7: feed to 140 -47.9282 0 F1000 t2.8161
8: event end code="M30"
end of program: 8 blocks, 8 motions, 0 errors, 1 warnings
