=== about
The same words on a machine that draws X upwards: the other way round, which a warning tells.
proves: fnc-1.3-G02
=== settings
control = flexnc
start = 100 0 50
param.arc_view = 1
=== main
T1M06D1
S300M03
G98F100
G00X53Z-34
G02X15Z-150I-46K-6
M02
=== truth
53 0 -34
15 0 -150 center 7 0 -40 sweep -266.728234
=== says
fnc-arc-view
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
main.nc:5:1: warning[fnc-arc-view]: the arc goes the long way round, 267 degrees: does the machine draw X down? Then set arc_view in [control.flexnc]
    G02X15Z-150I-46K-6
    ^~~~~~~~~~~~~~~~~~
5: feed arc to 15 0 -150 center 7 0 -40 normal 0 1 0 sweep -266.7282 F100 t222.3475
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 2 motions, 0 errors, 2 warnings
