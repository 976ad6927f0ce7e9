=== about
proves: nct-4.3-G2 nct-4.3-G3 nct-4.3-R nct-4.2-G1 nct-4.1-G0 nct-5.1-G90
=== main
G90 G17
G0 X130 Y0 M3 S1000
G1 Y20 F500
G3 X60 Y90 R70
G2 X40 Y50 R50
G1 X0
M30
=== truth
rapid 130 0 0
feed 130 20 0
feed 60 90 0 center 60 20 0 sweep 90 F 500 t 13.1947
feed 40 50 0 center 10 90 0 sweep -53.1301 t 5.5638
feed 0 50 0
=== expect
file 0 main.nc
2: event spindle rpm=1000 direction="cw"
2: rapid from 0 0 0 to 130 0 0 t0.52
3: feed to 130 20 0 F500 t2.4
4: feed arc to 60 90 0 center 60 20 0 normal 0 0 1 sweep 90 F500 t13.1947
5: feed arc to 40 50 0 center 10 90 0 normal 0 0 1 sweep -53.1301 F500 t5.5638
6: feed to 0 50 0 F500 t4.8
7: event end code="M30"
end of program: 7 blocks, 5 motions, 0 errors, 0 warnings
