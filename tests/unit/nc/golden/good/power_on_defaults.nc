=== about
Codes at power-on that parameters choose: G1, G18, G91, G95. 0.5 mm a turn at 600 rpm is 300 mm/min; the arc lies in the plane ZX.
proves: nct-3-poweron
=== settings
N1300.G01 = 1
N1300.G18 = 1
N1300.G91 = 1
N1301.G95 = 1
=== main
S600 M3
X10 F0.5
X10
G3 Z20 K10
G90 G1
X#4001 Y#4002 Z#4003
X#4005 Y#4006 Z#4007
M30
=== truth
feed 10 0 0 F 300
feed 20 0 0
feed 20 0 20 center 20 0 10 sweep 180
1 18 90
95 21 40
=== expect
file 0 main.nc
1: event spindle rpm=600 direction="cw"
2: feed from 0 0 0 to 10 0 0 F300 t2
3: feed to 20 0 0 F300 t2
4: feed arc to 20 0 20 center 20 0 10 normal 0 1 0 sweep 180 F300 t6.2832
6: feed to 1 18 90 F300 t14.9466
7: feed to 95 21 40 F300 t21.3026
8: event end code="M30"
end of program: 8 blocks, 5 motions, 0 errors, 0 warnings
