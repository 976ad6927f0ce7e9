=== about
proves: nct-15.5.4-full nct-15.5.4-change
=== settings
D1 = 10
H1 = 0
=== main
F100
N10 G17 G0 X100 Y0
N20 M3 S500
N30 G41 X80 D1
N40 G1 X50
N50 G42 G3 I-50
N60 G41 G1 X80
N70 G40 X100
M30
=== truth
100 0 0
80 -10 0
59.1608 -10 0
59.1608 10 0 center 0 0 0 sweep 379.1881
80 10 0
100 0 0
=== expect
file 0 main.nc
2 N10: rapid from 0 0 0 to 100 0 0 t0.4
3 N20: event spindle rpm=500 direction="cw"
4 N30: rapid to 80 -10 0 t0.08
5 N40: feed to 59.1608 -10 0 F100 t12.5035
6 N50: feed arc to 59.1608 10 0 center 0 0 0 normal 0 0 1 sweep 379.1881 F100 t238.2509
7 N60: feed to 80 10 0 F100 t12.5035
8 N70: feed to 100 0 0 F100 t13.4164
9: event end code="M30"
end of program: 9 blocks, 6 motions, 0 errors, 0 warnings
