=== about
Digest wl4, 4.7: G36 moves the named axes to the machine zero, whatever their values.
proves: wl4-5.2-G36
=== settings
control = wl4-mill
G54 = 10 20 30
=== main
%HOME
G54 G1 X5 Y5 Z5 F100
G36 Z7
X6
G36 X0 Y0
G0 X0 Y0 Z0
M30
%
=== truth
feed 5 5 5
rapid 5 5 -30
feed 6 5 -30
rapid -10 -20 -30
rapid 0 0 0
=== expect
file 0 main.nc
2: feed from 0 0 0 to 5 5 5 F100 t5.1962
3: rapid to 5 5 -30 t0.14
4: feed to 6 5 -30 F100 t0.6
5: rapid to -10 -20 -30 t0.1
6: rapid to 0 0 0 t0.12
7: event end code="M30"
end of program: 6 blocks, 5 motions, 0 errors, 0 warnings
