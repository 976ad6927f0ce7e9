=== about
The same rectangle the other way round with the tool on the left.
proves: fnc-1.5b-G41
=== settings
control = flexnc
start = 100 0 50
param.RT.1 = 0.8
=== main
T1M06D1
S300M03
G98F100
g00z0x20
g41g01x10
z10
x0
z-10
x10
z0
g40x20
M02
=== truth
20 0 0
10.8 0 0
10.8 0 10
10 0 10.8 center 10 0 10 sweep -90
0 0 10.8
-0.8 0 10 center 0 0 10 sweep -90
-0.8 0 -10
0 0 -10.8 center 0 0 -10 sweep -90
10 0 -10.8
10.8 0 -10 center 10 0 -10 sweep -90
10.8 0 0
20 0 0
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
main.nc:4:1: note[fnc-rapid]: the job gives no rapid rates ([machine] rapid): rapids of two axes go straight, where the machine turns a corner
    g00z0x20
    ^~~~~~~~
4: rapid from 100 0 50 to 20 0 0 t0.32
5: feed to 10.8 0 0 F100 t5.52
6: feed to 10.8 0 10 F100 t6
6: feed arc to 10 0 10.8 center 10 0 10 normal 0 1 0 sweep -90 F100 t0.754
7: feed to 0 0 10.8 F100 t6
7: feed arc to -0.8 0 10 center 0 0 10 normal 0 1 0 sweep -90 F100 t0.754
8: feed to -0.8 0 -10 F100 t12
8: feed arc to 0 0 -10.8 center 0 0 -10 normal 0 1 0 sweep -90 F100 t0.754
9: feed to 10 0 -10.8 F100 t6
9: feed arc to 10.8 0 -10 center 10 0 -10 normal 0 1 0 sweep -90 F100 t0.754
10: feed to 10.8 0 0 F100 t6
11: feed to 20 0 0 F100 t5.52
12: event spindle rpm=0 direction="stop"
12: event end code="M02"
end of program: 12 blocks, 12 motions, 0 errors, 0 warnings
