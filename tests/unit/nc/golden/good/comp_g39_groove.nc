=== about
proves: nct-15.5.6-G39
=== settings
D1 = 5
=== main
N20 G0 G17 G40 G54
N30 X-30 Y150 Z5 M3 S300
N40 G42 X0 Y86.603 D1
N50 Z-2
N60 G1 X-50 Y0 F1000
N70 G39
N80 X50
N90 G39
N100 X0 Y86.603
N110 G39 I-50 J-86.603
N120 Z5
N130 X-40
N140 G40 Y120
M30
=== truth
-30 150 5
-4.3301 89.103 5
-4.3301 89.103 -2
-54.3301 2.5 -2
-50 -5 -2 center -50 0 -2
50 -5 -2
54.3301 2.5 -2 center 50 0 -2
4.3301 89.103 -2
-4.3301 89.103 -2 center 0 86.603 -2
-4.3301 89.103 5
-40 91.603 5
-40 120 5
=== expect
file 0 main.nc
2 N30: event spindle rpm=300 direction="cw"
2 N30: rapid from 0 0 0 to -30 150 5 t0.6
3 N40: rapid to -4.3301 89.103 5 t0.2436
4 N50: rapid to -4.3301 89.103 -2 t0.028
5 N60: feed to -54.3301 2.5 -2 F1000 t6
6 N70: feed arc to -50 -5 -2 center -50 0 -2 normal 0 0 1 sweep 119.9999 F1000 t0.6283
7 N80: feed to 50 -5 -2 F1000 t6
8 N90: feed arc to 54.3301 2.5 -2 center 50 0 -2 normal 0 0 1 sweep 119.9999 F1000 t0.6283
9 N100: feed to 4.3301 89.103 -2 F1000 t6
10 N110: feed arc to -4.3301 89.103 -2 center 0 86.603 -2 normal 0 0 1 sweep 120.0003 F1000 t0.6283
11 N120: feed to -4.3301 89.103 5 F1000 t0.42
12 N130: feed to -40 91.603 5 F1000 t2.1454
13 N140: feed to -40 120 5 F1000 t1.7038
14: event end code="M30"
end of program: 14 blocks, 12 motions, 0 errors, 0 warnings
