=== about
The manual's facing: six passes.
proves: fnc-3.6-G79
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G79X22Y12Z6P1C2B2
M02
=== truth
13 0 8
13 0 5
6 0 5
6 0 7
13 0 7
13 0 4
6 0 4
6 0 6
13 0 6
13 0 3
6 0 3
6 0 5
13 0 5
13 0 2
6 0 2
6 0 4
13 0 4
13 0 1
6 0 1
6 0 3
13 0 3
13 0 0
6 0 0
6 0 2
13 0 2
13 0 8
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G79 of line 4
1/1 depth 1: rapid from 100 0 50 to 13 0 8 t0.348
1/2 depth 1: feed to 13 0 5 F100 t1.8
1/3 depth 1: feed to 6 0 5 F100 t4.2
1/4 depth 1: feed to 6 0 7 F100 t1.2
1/5 depth 1: rapid to 13 0 7 t0.028
1/6 depth 1: feed to 13 0 4 F100 t1.8
1/7 depth 1: feed to 6 0 4 F100 t4.2
1/8 depth 1: feed to 6 0 6 F100 t1.2
1/9 depth 1: rapid to 13 0 6 t0.028
1/10 depth 1: feed to 13 0 3 F100 t1.8
1/11 depth 1: feed to 6 0 3 F100 t4.2
1/12 depth 1: feed to 6 0 5 F100 t1.2
1/13 depth 1: rapid to 13 0 5 t0.028
1/14 depth 1: feed to 13 0 2 F100 t1.8
1/15 depth 1: feed to 6 0 2 F100 t4.2
1/16 depth 1: feed to 6 0 4 F100 t1.2
1/17 depth 1: rapid to 13 0 4 t0.028
1/18 depth 1: feed to 13 0 1 F100 t1.8
1/19 depth 1: feed to 6 0 1 F100 t4.2
1/20 depth 1: feed to 6 0 3 F100 t1.2
1/21 depth 1: rapid to 13 0 3 t0.028
1/22 depth 1: feed to 13 0 0 F100 t1.8
1/23 depth 1: feed to 6 0 0 F100 t4.2
1/24 depth 1: feed to 6 0 2 F100 t1.2
1/25 depth 1: rapid to 13 0 2 t0.028
1/26 depth 1: rapid to 13 0 8 t0.024
5: event spindle rpm=0 direction="stop"
5: event end code="M02"
end of program: 5 blocks, 26 motions, 0 errors, 0 warnings
