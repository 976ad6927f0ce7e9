=== about
proves: nct-18.1.13-G87A
=== settings
N0607.ORI = 0
=== main
G0 X0 Y0 Z50 S100 M3
G99 G87 X10 Y0 Z-20 R2 F60
M30
=== truth
0 0 50
10 0 50
10 0 2
feed 10 0 -20
rapid 10 0 2
=== says
feed to 10 0 -20
direction="stop"
stop code="M0"
rapid to 10 0 2
direction="cw"
=== expect
file 0 main.nc
1: event spindle rpm=100 direction="cw"
1: rapid from 0 0 0 to 0 0 50 t0.2
2: rapid to 10 0 50 t0.04
2: rapid to 10 0 2 t0.192
2: feed to 10 0 -20 F60 t22
2: event spindle rpm=0 direction="stop"
2: event stop code="M0" reason="manual intervention in the cycle"
2: rapid to 10 0 2 t0.088
2: event spindle rpm=100 direction="cw"
3: event end code="M30"
end of program: 3 blocks, 5 motions, 0 errors, 0 warnings
