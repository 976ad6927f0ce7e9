=== about
A thread in two blocks behind its start point: depths by a law that takes less from pass to pass, one spring pass.
proves: fnc-3.6-G76a fnc-3.6-G76b
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G90G00X(50/2)Z16
G76P010000Q0.1R0
G76X20Z-10P1Q0.5R0F1.5
M02
=== truth
25 0 16
9.500000 0 16
9.500000 0 -10
25 0 -10
25 0 16
9.400000 0 16
9.400000 0 -10
25 0 -10
25 0 16
9.314435 0 16
9.314435 0 -10
25 0 -10
25 0 16
9.238423 0 16
9.238423 0 -10
25 0 -10
25 0 16
9.169338 0 16
9.169338 0 -10
25 0 -10
25 0 16
9.105573 0 16
9.105573 0 -10
25 0 -10
25 0 16
9.046061 0 16
9.046061 0 -10
25 0 -10
25 0 16
9.000000 0 16
9.000000 0 -10
25 0 -10
25 0 16
9.000000 0 16
9.000000 0 -10
25 0 -10
25 0 16
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
main.nc:4:1: note[fnc-rapid]: the job gives no rapid rates ([machine] rapid): rapids of two axes go straight, where the machine turns a corner
    G90G00X(50/2)Z16
    ^~~~~~~~~~~~~~~~
4: rapid from 100 0 50 to 25 0 16 t0.3
file 1 G76 of line 6
1/1 depth 1: rapid to 9.5 0 16 t0.062
1/2 depth 1: thread to 9.5 0 -10 F450 t3.4667
1/3 depth 1: rapid to 25 0 -10 t0.062
1/4 depth 1: rapid to 25 0 16 t0.104
1/5 depth 1: rapid to 9.4 0 16 t0.0624
1/6 depth 1: thread to 9.4 0 -10 F450 t3.4667
1/7 depth 1: rapid to 25 0 -10 t0.0624
1/8 depth 1: rapid to 25 0 16 t0.104
1/9 depth 1: rapid to 9.3144 0 16 t0.0627
1/10 depth 1: thread to 9.3144 0 -10 F450 t3.4667
1/11 depth 1: rapid to 25 0 -10 t0.0627
1/12 depth 1: rapid to 25 0 16 t0.104
1/13 depth 1: rapid to 9.2384 0 16 t0.063
1/14 depth 1: thread to 9.2384 0 -10 F450 t3.4667
1/15 depth 1: rapid to 25 0 -10 t0.063
1/16 depth 1: rapid to 25 0 16 t0.104
1/17 depth 1: rapid to 9.1693 0 16 t0.0633
1/18 depth 1: thread to 9.1693 0 -10 F450 t3.4667
1/19 depth 1: rapid to 25 0 -10 t0.0633
1/20 depth 1: rapid to 25 0 16 t0.104
1/21 depth 1: rapid to 9.1056 0 16 t0.0636
1/22 depth 1: thread to 9.1056 0 -10 F450 t3.4667
1/23 depth 1: rapid to 25 0 -10 t0.0636
1/24 depth 1: rapid to 25 0 16 t0.104
1/25 depth 1: rapid to 9.0461 0 16 t0.0638
1/26 depth 1: thread to 9.0461 0 -10 F450 t3.4667
1/27 depth 1: rapid to 25 0 -10 t0.0638
1/28 depth 1: rapid to 25 0 16 t0.104
1/29 depth 1: rapid to 9 0 16 t0.064
1/30 depth 1: thread to 9 0 -10 F450 t3.4667
1/31 depth 1: rapid to 25 0 -10 t0.064
1/32 depth 1: rapid to 25 0 16 t0.104
1/33 depth 1: rapid to 9 0 16 t0.064
1/34 depth 1: thread to 9 0 -10 F450 t3.4667
1/35 depth 1: rapid to 25 0 -10 t0.064
1/36 depth 1: rapid to 25 0 16 t0.104
7: event spindle rpm=0 direction="stop"
7: event end code="M02"
end of program: 7 blocks, 37 motions, 0 errors, 0 warnings
