=== about
The constructed program: start block, roughing with a shift from the face, end block.
proves: fnc-4.4-order fnc-3.1-V
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S222M03
G98F120
G77X60A40Y10Z0P3C2B2V15
G81X100Z100
M02
=== truth
32 0 -13
27 0 -13
27 0 -22
27.4 0 -22
27.4 0 -13
24 0 -13
24 0 -19
24.4 0 -19
24.4 0 -13
21 0 -13
21 0 -16
21.4 0 -16
21.4 0 -13
20 0 -13
20 0 -15
30 0 -25
32 0 -25
32 0 -13
50 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=222 direction="cw"
file 1 G77 of line 4
1/1 depth 1: rapid from 100 0 50 to 32 0 -13 t0.272
1/2 depth 1: feed to 27 0 -13 F120 t2.5
1/3 depth 1: feed to 27 0 -22 F120 t4.5
1/4 depth 1: feed to 27.4 0 -22 F120 t0.2
1/5 depth 1: rapid to 27.4 0 -13 t0.036
1/6 depth 1: feed to 24 0 -13 F120 t1.7
1/7 depth 1: feed to 24 0 -19 F120 t3
1/8 depth 1: feed to 24.4 0 -19 F120 t0.2
1/9 depth 1: rapid to 24.4 0 -13 t0.024
1/10 depth 1: feed to 21 0 -13 F120 t1.7
1/11 depth 1: feed to 21 0 -16 F120 t1.5
1/12 depth 1: feed to 21.4 0 -16 F120 t0.2
1/13 depth 1: rapid to 21.4 0 -13 t0.012
1/14 depth 1: feed to 20 0 -13 F120 t0.7
1/15 depth 1: feed to 20 0 -15 F120 t1
1/16 depth 1: feed to 30 0 -25 F120 t7.0711
1/17 depth 1: rapid to 32 0 -25 t0.008
1/18 depth 1: rapid to 32 0 -13 t0.048
5: rapid to 50 0 100 t0.452
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 19 motions, 0 errors, 0 warnings
