=== about
The same in a hole, with the tool on the other side.
proves: fnc-3.6-G81.2
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G99F0.15
G81.2X40Z5
G12X9R14P0C-2K1
G81X60Z100
M02
=== truth
20 0 5
20 0 0
18.5 0 0
4.5 0 -14 center 18.5 0 -14 sweep -90
30 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
4: rapid from 100 0 50 to 20 0 5 t0.32
file 1 G12 of line 5
4: feed to 20 0 0 F45 t6.6667
1/1 depth 1: feed to 18.5 0 0 F45 t2
1/2 depth 1: feed arc to 4.5 0 -14 center 18.5 0 -14 normal 0 1 0 sweep -90 F45 t29.3215
6: rapid to 30 0 100 t0.456
7: event spindle rpm=0 direction="stop"
7: event end code="M02"
end of program: 7 blocks, 5 motions, 0 errors, 0 warnings
