=== about
proves: nct-15.5.6-G39
=== settings
D1 = 5
=== main
G17 G90 G0 X-50 Y0
G41 G1 X0 D1 F100
N110 G91 X100
N120 G39 I50 J-60
N130 G40 X110 Y30
M30
=== truth
-50 0 0
0 5 0
100 5 0
103.8411 3.2009 0 center 100 0 0
210 30 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -50 0 0 t0.2
2: feed to 0 5 0 F100 t30.1496
3 N110: feed to 100 5 0 F100 t60
4 N120: feed arc to 103.8411 3.2009 0 center 100 0 0 normal 0 0 1 sweep -50.1944 F100 t2.6282
5 N130: feed to 210 30 0 F100 t65.6936
6: event end code="M30"
end of program: 6 blocks, 5 motions, 0 errors, 0 warnings
