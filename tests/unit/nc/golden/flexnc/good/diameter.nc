=== about
X and I outside of templates as diameters.
proves: fnc-0-coord
=== settings
control = flexnc
start = 100 0 50
param.raw_x = 1
=== main
T1M06D1
S300M03
G98F100
G00X60Z0
G03X40Z-10I0K-10
G91G01X10
M02
=== truth
30 0 0
20 0 -10 center 30 0 -10 sweep -90
25 0 -10
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
main.nc:4:1: note[fnc-rapid]: the job gives no rapid rates ([machine] rapid): rapids of two axes go straight, where the machine turns a corner
    G00X60Z0
    ^~~~~~~~
4: rapid from 100 0 50 to 30 0 0 t0.28
5: feed arc to 20 0 -10 center 30 0 -10 normal 0 1 0 sweep -90 F100 t9.4248
6: feed to 25 0 -10 F100 t3
7: event spindle rpm=0 direction="stop"
7: event end code="M02"
end of program: 7 blocks, 3 motions, 0 errors, 0 warnings
