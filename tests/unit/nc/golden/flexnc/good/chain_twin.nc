=== about
G81.3 is the twin of G81.1; a sharp tool.
proves: fnc-3.6-G81.3
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G99F0.15
G81.3X0Z5
G12X40R15P0C2K1
G77X60A40Y10P0C2K0
G81X100Z100
M02
=== truth
0 0 5
0 0 0
5 0 0
20 0 -15 center 5 0 -15 sweep 90
30 0 -25
50 0 100
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
4: rapid from 100 0 50 to 0 0 5 t0.4
file 1 G12 of line 5
4: feed to 0 0 0 F45 t6.6667
1/1 depth 1: feed to 5 0 0 F45 t6.6667
file 2 G77 of line 6
1/2 depth 1: feed arc to 20 0 -15 center 5 0 -15 normal 0 1 0 sweep 90 F45 t31.4159
2/1 depth 1: feed to 30 0 -25 F45 t18.8562
7: rapid to 50 0 100 t0.5
8: event spindle rpm=0 direction="stop"
8: event end code="M02"
end of program: 8 blocks, 6 motions, 0 errors, 0 warnings
