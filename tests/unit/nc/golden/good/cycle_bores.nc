=== about
I is the feed out in percent: 30 and 120 mm/min.
proves: nct-18.1.12-G86 nct-18.1.14-G88 nct-18.1.15-G89 nct-18.1.11-G85 nct-3-G85 nct-3-G86 nct-3-G88 nct-3-G89
=== main
G0 Z50 S100 M3
G99 G86 X10 Z-20 R2 F60
G88 X20 P1
G89 X30 P1 I50
G98 G85 X40 I200
G80
M30
=== truth
0 0 50
10 0 50
10 0 2
feed 10 0 -20
rapid 10 0 2
20 0 2
feed 20 0 -20
rapid 20 0 2
30 0 2
feed 30 0 -20
feed 30 0 2
40 0 2
feed 40 0 -20
feed 40 0 2
rapid 40 0 50
=== expect
file 0 main.nc
1: event spindle rpm=100 direction="cw"
1: rapid from 0 0 0 to 0 0 50 t0.2
2: rapid to 10 0 50 t0.04
2: rapid to 10 0 2 t0.192
2: feed to 10 0 -20 F60 t22
2: event spindle rpm=0 direction="stop"
2: rapid to 10 0 2 t0.088
2: event spindle rpm=100 direction="cw"
3: rapid to 20 0 2 t0.04
3: feed to 20 0 -20 F60 t22
3: event dwell seconds=1
3: event spindle rpm=0 direction="stop"
3: event stop code="M0" reason="manual intervention in the cycle"
3: rapid to 20 0 2 t0.088
3: event spindle rpm=100 direction="cw"
4: rapid to 30 0 2 t0.04
4: feed to 30 0 -20 F60 t22
4: event dwell seconds=1
4: feed to 30 0 2 F30 t44
5: rapid to 40 0 2 t0.04
5: feed to 40 0 -20 F60 t22
5: feed to 40 0 2 F120 t11
5: rapid to 40 0 50 t0.192
7: event end code="M30"
end of program: 7 blocks, 15 motions, 0 errors, 0 warnings
