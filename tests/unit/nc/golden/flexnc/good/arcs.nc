=== about
The manual's arc, whose numbers are no circle, absolute and in increments: the same spiral. A quarter the other way.
proves: fnc-1.3-G02 fnc-1.3-G03
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G00X53Z-34
G02X15Z-150I-46K-6
G00X53Z-34
G91G02X-38Z-116I-46K-6
G90G00X30Z0
G03X20Z-10K-10
M02
=== truth
53 0 -34
15 0 -150 center 7 0 -40 sweep 93.271766
53 0 -34
15 0 -150 center 7 0 -40 sweep 93.271766
30 0 0
20 0 -10 center 30 0 -10 sweep -90
=== says
fnc-arc-radius
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
main.nc:4:1: note[fnc-rapid]: the job gives no rapid rates ([machine] rapid): rapids of two axes go straight, where the machine turns a corner
    G00X53Z-34
    ^~~~~~~~~~
4: rapid from 100 0 50 to 53 0 -34 t0.336
main.nc:5:1: warning[fnc-arc-radius]: start and end are 46.3897 and 110.2905 mm from the centre: the radius changes along the way, a spiral
    G02X15Z-150I-46K-6
    ^~~~~~~~~~~~~~~~~~
5: feed arc to 15 0 -150 center 7 0 -40 normal 0 1 0 sweep 93.2718 F100 t85.9906
6: rapid to 53 0 -34 t0.464
main.nc:7:1: warning[fnc-arc-radius]: start and end are 46.3897 and 110.2905 mm from the centre: the radius changes along the way, a spiral
    G91G02X-38Z-116I-46K-6
    ^~~~~~~~~~~~~~~~~~~~~~
7: feed arc to 15 0 -150 center 7 0 -40 normal 0 1 0 sweep 93.2718 F100 t85.9906
8: rapid to 30 0 0 t0.6
9: feed arc to 20 0 -10 center 30 0 -10 normal 0 1 0 sweep -90 F100 t9.4248
10: event spindle rpm=0 direction="stop"
10: event end code="M02"
end of program: 10 blocks, 6 motions, 0 errors, 2 warnings
