=== about
G10.9: from radius to diameter and back, without motion; X80 is then radius 40.
proves: nct-5.3.1-G10.9 nct-5.3.1-N0106-5
=== settings
N0106.MGD.2 = 0
=== main
G1 X50 F100
G10.9 X1
G1 X80
G91 X10
G90
G10.9 X0
X80
M30
=== truth
feed 50 0 0
feed 40 0 0
feed 45 0 0
feed 80 0 0
=== expect
file 0 main.nc
1: feed from 0 0 0 to 50 0 0 F100 t30
3: feed to 40 0 0 F100 t6
4: feed to 45 0 0 F100 t3
7: feed to 80 0 0 F100 t21
8: event end code="M30"
end of program: 8 blocks, 4 motions, 0 errors, 0 warnings
