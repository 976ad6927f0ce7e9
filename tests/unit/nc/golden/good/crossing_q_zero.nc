=== about
Q0 is the first point, like no Q.
proves: nct-17.3.2-LA
=== main
G17 G42 G0 X100 Y20 D0 F100
G1 X-30 Y-20
G3 X20 Y40 I20 J-10 R50 Q0
G40 G0 Y60
M30
=== truth
100 20 0
66.0216 9.5451 0
20 40 0 center 20 -10 0 sweep 66.9894
20 60 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 100 20 0 t0.4
2: feed to 66.0216 9.5451 0 F100 t21.3303
3: feed arc to 20 40 0 center 20 -10 0 normal 0 0 1 sweep 66.9894 F100 t35.0755
4: rapid to 20 60 0 t0.08
5: event end code="M30"
end of program: 5 blocks, 4 motions, 0 errors, 0 warnings
