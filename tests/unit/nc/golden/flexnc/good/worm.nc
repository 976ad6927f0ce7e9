=== about
Two starts, half a turn apart; the passes of each by layers and across the groove.
Truth: digest flexnc 10.9; the tool's centre keeps within R - Q = 5 of r 20: at tool depth 5 over 10 mm by steps of 2,
at depth 10 in the middle, once a start; the way is L + Z and half the groove; 300 turns of lead 20.
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
=== truth
rapid 22 0 5
rapid 15 0 5
thread 15 0 -35 F 6000 start 0
rapid 22
rapid 22 0 5
rapid *
rapid 15 0 7
thread 15 0 -33 F 6000 start 0
rapid 22
rapid 22 0 5
rapid *
rapid 15 0 9
thread 15 0 -31 F 6000 start 0
rapid 22
rapid 22 0 5
rapid *
rapid 15 0 11
thread 15 0 -29 F 6000 start 0
rapid 22
rapid 22 0 5
rapid *
rapid 15 0 13
thread 15 0 -27 F 6000 start 0
rapid 22
rapid 22 0 5
rapid *
rapid 15 0 15
thread 15 0 -25 F 6000 start 0
rapid 22
rapid 22 0 5
rapid *
rapid 10 0 10
thread 10 0 -30 F 6000 start 0
rapid 22
rapid 22 0 5
rapid 15 0 5
thread 15 0 -35 F 6000 start 180
rapid 22
rapid 22 0 5
rapid *
rapid 15 0 7
thread 15 0 -33 F 6000 start 180
rapid 22
rapid 22 0 5
rapid *
rapid 15 0 9
thread 15 0 -31 F 6000 start 180
rapid 22
rapid 22 0 5
rapid *
rapid 15 0 11
thread 15 0 -29 F 6000 start 180
rapid 22
rapid 22 0 5
rapid *
rapid 15 0 13
thread 15 0 -27 F 6000 start 180
rapid 22
rapid 22 0 5
rapid *
rapid 15 0 15
thread 15 0 -25 F 6000 start 180
rapid 22
rapid 22 0 5
rapid *
rapid 10 0 10
thread 10 0 -30 F 6000 start 180
rapid 22
rapid 22 0 5
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G30 of line 4
1/1 depth 1: rapid from 100 0 50 to 22 0 5 t0.312
1/2 depth 1: rapid to 15 0 5 t0.028
1/3 depth 1: thread to 15 0 -35 F6000 t0.4
1/4 depth 1: rapid to 22 0 -35 t0.028
1/5 depth 1: rapid to 22 0 5 t0.16
1/6 depth 1: rapid to 22 0 7 t0.008
1/7 depth 1: rapid to 15 0 7 t0.028
1/8 depth 1: thread to 15 0 -33 F6000 t0.4
1/9 depth 1: rapid to 22 0 -33 t0.028
1/10 depth 1: rapid to 22 0 5 t0.152
1/11 depth 1: rapid to 22 0 9 t0.016
1/12 depth 1: rapid to 15 0 9 t0.028
1/13 depth 1: thread to 15 0 -31 F6000 t0.4
1/14 depth 1: rapid to 22 0 -31 t0.028
1/15 depth 1: rapid to 22 0 5 t0.144
1/16 depth 1: rapid to 22 0 11 t0.024
1/17 depth 1: rapid to 15 0 11 t0.028
1/18 depth 1: thread to 15 0 -29 F6000 t0.4
1/19 depth 1: rapid to 22 0 -29 t0.028
1/20 depth 1: rapid to 22 0 5 t0.136
1/21 depth 1: rapid to 22 0 13 t0.032
1/22 depth 1: rapid to 15 0 13 t0.028
1/23 depth 1: thread to 15 0 -27 F6000 t0.4
1/24 depth 1: rapid to 22 0 -27 t0.028
1/25 depth 1: rapid to 22 0 5 t0.128
1/26 depth 1: rapid to 22 0 15 t0.04
1/27 depth 1: rapid to 15 0 15 t0.028
1/28 depth 1: thread to 15 0 -25 F6000 t0.4
1/29 depth 1: rapid to 22 0 -25 t0.028
1/30 depth 1: rapid to 22 0 5 t0.12
1/31 depth 1: rapid to 22 0 10 t0.02
1/32 depth 1: rapid to 10 0 10 t0.048
1/33 depth 1: thread to 10 0 -30 F6000 t0.4
1/34 depth 1: rapid to 22 0 -30 t0.048
1/35 depth 1: rapid to 22 0 5 t0.14
1/36 depth 1: rapid to 15 0 5 t0.028
1/37 depth 1: thread to 15 0 -35 F6000 t0.4 start 180
1/38 depth 1: rapid to 22 0 -35 t0.028
1/39 depth 1: rapid to 22 0 5 t0.16
1/40 depth 1: rapid to 22 0 7 t0.008
1/41 depth 1: rapid to 15 0 7 t0.028
1/42 depth 1: thread to 15 0 -33 F6000 t0.4 start 180
1/43 depth 1: rapid to 22 0 -33 t0.028
1/44 depth 1: rapid to 22 0 5 t0.152
1/45 depth 1: rapid to 22 0 9 t0.016
1/46 depth 1: rapid to 15 0 9 t0.028
1/47 depth 1: thread to 15 0 -31 F6000 t0.4 start 180
1/48 depth 1: rapid to 22 0 -31 t0.028
1/49 depth 1: rapid to 22 0 5 t0.144
1/50 depth 1: rapid to 22 0 11 t0.024
1/51 depth 1: rapid to 15 0 11 t0.028
1/52 depth 1: thread to 15 0 -29 F6000 t0.4 start 180
1/53 depth 1: rapid to 22 0 -29 t0.028
1/54 depth 1: rapid to 22 0 5 t0.136
1/55 depth 1: rapid to 22 0 13 t0.032
1/56 depth 1: rapid to 15 0 13 t0.028
1/57 depth 1: thread to 15 0 -27 F6000 t0.4 start 180
1/58 depth 1: rapid to 22 0 -27 t0.028
1/59 depth 1: rapid to 22 0 5 t0.128
1/60 depth 1: rapid to 22 0 15 t0.04
1/61 depth 1: rapid to 15 0 15 t0.028
1/62 depth 1: thread to 15 0 -25 F6000 t0.4 start 180
1/63 depth 1: rapid to 22 0 -25 t0.028
1/64 depth 1: rapid to 22 0 5 t0.12
1/65 depth 1: rapid to 22 0 10 t0.02
1/66 depth 1: rapid to 10 0 10 t0.048
1/67 depth 1: thread to 10 0 -30 F6000 t0.4 start 180
1/68 depth 1: rapid to 22 0 -30 t0.048
1/69 depth 1: rapid to 22 0 5 t0.14
5: event spindle rpm=0 direction="stop"
5: event end code="M02"
end of program: 5 blocks, 69 motions, 0 errors, 0 warnings
