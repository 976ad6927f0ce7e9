=== about
A step shorter than the cutter's radius is left out: corner (25.6795,10).
proves: nct-15.5.7-AAL
=== settings
D1 = 10
=== main
G0 X-100
G41 G1 X-50 D1 F1000
X40
X41.5 Y2.598076
X21.5 Y37.239092
X1.5 Y71.880108
G40 X-20 Y120
M30
=== truth
-100 0 0
-50 10 0
25.6795 10 0
* * 0
* * 0
-20 120 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: feed to -50 10 0 F1000 t3.0594
main.nc:4:1: warning[nct-cutter-comp]: interference in cutter compensation: this block is left out of the path
    X41.5 Y2.598076
    ^~~~~~~~~~~~~~~
3: feed to 25.6795 10 0 F1000 t4.5408
5: feed to 12.8397 32.2391 0 F1000 t1.5408
6: feed to -7.419 67.3283 0 F1000 t2.4311
7: feed to -20 120 0 F1000 t3.2492
8: event end code="M30"
end of program: 8 blocks, 6 motions, 0 errors, 1 warnings
