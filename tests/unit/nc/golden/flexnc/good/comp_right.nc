=== about
The manual's program: around a rectangle with the tool on the right. Arcs about the outside corners, the way in at right
angles to the first side.
proves: fnc-1.5b-G42 fnc-1.5b-G40 fnc-1.5b-intro fnc-1.5b-outer
=== settings
control = flexnc
start = 100 0 50
param.RT.1 = 0.8
=== main
t1m06d1
s300m03
G90
g00z0x20
G98F100
//ВКЛ КОРРЕКЦИИ
g42g01x10
z-10
x0
z10
x10
z0
//ОТМЕНА КОРРЕКЦИИ
g40x20
M02
=== truth
20 0 0
10.8 0 0
10.8 0 -10
10 0 -10.8 center 10 0 -10 sweep 90
0 0 -10.8
-0.8 0 -10 center 0 0 -10 sweep 90
-0.8 0 10
0 0 10.8 center 0 0 10 sweep 90
10 0 10.8
10.8 0 10 center 10 0 10 sweep 90
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
7: feed to 10.8 0 0 F100 t5.52
8: feed to 10.8 0 -10 F100 t6
8: feed arc to 10 0 -10.8 center 10 0 -10 normal 0 1 0 sweep 90 F100 t0.754
9: feed to 0 0 -10.8 F100 t6
9: feed arc to -0.8 0 -10 center 0 0 -10 normal 0 1 0 sweep 90 F100 t0.754
10: feed to -0.8 0 10 F100 t12
10: feed arc to 0 0 10.8 center 0 0 10 normal 0 1 0 sweep 90 F100 t0.754
11: feed to 10 0 10.8 F100 t6
11: feed arc to 10.8 0 10 center 10 0 10 normal 0 1 0 sweep 90 F100 t0.754
12: feed to 10.8 0 0 F100 t6
14: feed to 20 0 0 F100 t5.52
15: event spindle rpm=0 direction="stop"
15: event end code="M02"
end of program: 13 blocks, 12 motions, 0 errors, 0 warnings
