=== about
The manual's deep drilling.
proves: fnc-3.6-G5
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G5P5Y1Z20B2V0
M02
=== truth
0 0 2
0 0 -5
0 0 2
0 0 -4
0 0 -10
0 0 2
0 0 -9
0 0 -15
0 0 2
0 0 -14
0 0 -20
0 0 2
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G5 of line 4
1/1 depth 1: rapid from 100 0 50 to 0 0 2 t0.4
1/2 depth 1: feed to 0 0 -5 F100 t4.2
1/3 depth 1: rapid to 0 0 2 t0.028
1/4 depth 1: rapid to 0 0 -4 t0.024
1/5 depth 1: feed to 0 0 -10 F100 t3.6
1/6 depth 1: rapid to 0 0 2 t0.048
1/7 depth 1: rapid to 0 0 -9 t0.044
1/8 depth 1: feed to 0 0 -15 F100 t3.6
1/9 depth 1: rapid to 0 0 2 t0.068
1/10 depth 1: rapid to 0 0 -14 t0.064
1/11 depth 1: feed to 0 0 -20 F100 t3.6
1/12 depth 1: rapid to 0 0 2 t0.088
5: event spindle rpm=0 direction="stop"
5: event end code="M02"
end of program: 5 blocks, 12 motions, 0 errors, 0 warnings
