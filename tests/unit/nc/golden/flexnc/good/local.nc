=== about
G52 names the point where the tool stands; X0Z0 ends it.
proves: fnc-1.5-G52
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G00X50Z10
G52X20Z5
G90G01X25Z5F100
G52X0Z0
G01X56
M02
=== truth
50 0 10
55 0 10
56 0 10
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
main.nc:4:1: note[fnc-rapid]: the job gives no rapid rates ([machine] rapid): rapids of two axes go straight, where the machine turns a corner
    G00X50Z10
    ^~~~~~~~~
4: rapid from 100 0 50 to 50 0 10 t0.2
6: feed to 55 0 10 F100 t3
8: feed to 56 0 10 F100 t0.6
9: event spindle rpm=0 direction="stop"
9: event end code="M02"
end of program: 9 blocks, 3 motions, 0 errors, 0 warnings
