=== about
Two starts, half a turn apart; the passes of each by layers and across the groove.
proves: fnc-3.6-G30
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G30A20X40Z30R10Q5F20H2P5U44L5K2
M02
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G30 of line 4
1/1 depth 1: rapid from 100 0 50 to 22 0 5 t0.312
1/2 depth 1: rapid to 15 0 5 t0.028
1/3 depth 1: thread to 15 0 -30 F6000 t0.35 start 270
1/4 depth 1: rapid to 22 0 -30 t0.028
1/5 depth 1: rapid to 22 0 5 t0.14
1/6 depth 1: rapid to 15 0 5 t0.028
1/7 depth 1: thread to 15 0 -30 F6000 t0.35 start 306
1/8 depth 1: rapid to 22 0 -30 t0.028
1/9 depth 1: rapid to 22 0 5 t0.14
1/10 depth 1: rapid to 15 0 5 t0.028
1/11 depth 1: thread to 15 0 -30 F6000 t0.35 start 342
1/12 depth 1: rapid to 22 0 -30 t0.028
1/13 depth 1: rapid to 22 0 5 t0.14
1/14 depth 1: rapid to 15 0 5 t0.028
1/15 depth 1: thread to 15 0 -30 F6000 t0.35 start 18
1/16 depth 1: rapid to 22 0 -30 t0.028
1/17 depth 1: rapid to 22 0 5 t0.14
1/18 depth 1: rapid to 15 0 5 t0.028
1/19 depth 1: thread to 15 0 -30 F6000 t0.35 start 54
1/20 depth 1: rapid to 22 0 -30 t0.028
1/21 depth 1: rapid to 22 0 5 t0.14
1/22 depth 1: rapid to 15 0 5 t0.028
1/23 depth 1: thread to 15 0 -30 F6000 t0.35 start 90
1/24 depth 1: rapid to 22 0 -30 t0.028
1/25 depth 1: rapid to 22 0 5 t0.14
1/26 depth 1: rapid to 10 0 5 t0.048
1/27 depth 1: thread to 10 0 -30 F6000 t0.35
1/28 depth 1: rapid to 22 0 -30 t0.048
1/29 depth 1: rapid to 22 0 5 t0.14
1/30 depth 1: rapid to 15 0 5 t0.028
1/31 depth 1: thread to 15 0 -30 F6000 t0.35 start 90
1/32 depth 1: rapid to 22 0 -30 t0.028
1/33 depth 1: rapid to 22 0 5 t0.14
1/34 depth 1: rapid to 15 0 5 t0.028
1/35 depth 1: thread to 15 0 -30 F6000 t0.35 start 126
1/36 depth 1: rapid to 22 0 -30 t0.028
1/37 depth 1: rapid to 22 0 5 t0.14
1/38 depth 1: rapid to 15 0 5 t0.028
1/39 depth 1: thread to 15 0 -30 F6000 t0.35 start 162
1/40 depth 1: rapid to 22 0 -30 t0.028
1/41 depth 1: rapid to 22 0 5 t0.14
1/42 depth 1: rapid to 15 0 5 t0.028
1/43 depth 1: thread to 15 0 -30 F6000 t0.35 start 198
1/44 depth 1: rapid to 22 0 -30 t0.028
1/45 depth 1: rapid to 22 0 5 t0.14
1/46 depth 1: rapid to 15 0 5 t0.028
1/47 depth 1: thread to 15 0 -30 F6000 t0.35 start 234
1/48 depth 1: rapid to 22 0 -30 t0.028
1/49 depth 1: rapid to 22 0 5 t0.14
1/50 depth 1: rapid to 15 0 5 t0.028
1/51 depth 1: thread to 15 0 -30 F6000 t0.35 start 270
1/52 depth 1: rapid to 22 0 -30 t0.028
1/53 depth 1: rapid to 22 0 5 t0.14
1/54 depth 1: rapid to 10 0 5 t0.048
1/55 depth 1: thread to 10 0 -30 F6000 t0.35 start 180
1/56 depth 1: rapid to 22 0 -30 t0.048
1/57 depth 1: rapid to 22 0 5 t0.14
5: event spindle rpm=0 direction="stop"
5: event end code="M02"
end of program: 5 blocks, 57 motions, 0 errors, 0 warnings
