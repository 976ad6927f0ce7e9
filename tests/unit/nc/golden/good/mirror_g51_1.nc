=== about
proves: nct-3-G51.1 nct-3-G50.1 nct-16.3-G51.1 nct-16.3-G50.1
=== main
N1 G0 X100 Y0
N2 M98 P101
N3 G51.1 X140
N4 M98 P101
N5 G51.1 Y100
N6 M98 P101
N7 G50.1 X0
N8 M98 P101
N9 G50.1 Y0
N10 G0 X100 Y0
M30
=== sub O0101.nc
N1 G90 G0 X180 Y120 F120
N2 G1 X240
N3 Y160
N4 G3 X180 Y120 R80
N5 M99
=== truth
100 0 0
180 120 0
240 120 0
240 160 0
180 120 0 center 249.6135 80.5797 0 sweep 53.5764
100 120 0
40 120 0
40 160 0
100 120 0 center 30.3865 80.5797 0 sweep -53.5764
100 80 0
40 80 0
40 40 0
100 80 0 center 30.3865 119.4203 0 sweep 53.5764
180 80 0
240 80 0
240 40 0
180 80 0 center 249.6135 119.4203 0 sweep -53.5764
100 0 0
=== expect
file 0 main.nc
1 N1: rapid from 0 0 0 to 100 0 0 t0.4
file 1 O0101.nc
1/1 N1 depth 1: rapid to 180 120 0 t0.48
1/2 N2 depth 1: feed to 240 120 0 F120 t30
1/3 N3 depth 1: feed to 240 160 0 F120 t20
1/4 N4 depth 1: feed arc to 180 120 0 center 249.6135 80.5797 0 normal 0 0 1 sweep 53.5764 F120 t37.4034
1/1 N1 depth 1: rapid to 100 120 0 t0.32
1/2 N2 depth 1: feed to 40 120 0 F120 t30
1/3 N3 depth 1: feed to 40 160 0 F120 t20
1/4 N4 depth 1: feed arc to 100 120 0 center 30.3865 80.5797 0 normal 0 0 1 sweep -53.5764 F120 t37.4034
1/1 N1 depth 1: rapid to 100 80 0 t0.16
1/2 N2 depth 1: feed to 40 80 0 F120 t30
1/3 N3 depth 1: feed to 40 40 0 F120 t20
1/4 N4 depth 1: feed arc to 100 80 0 center 30.3865 119.4203 0 normal 0 0 1 sweep 53.5764 F120 t37.4034
1/1 N1 depth 1: rapid to 180 80 0 t0.32
1/2 N2 depth 1: feed to 240 80 0 F120 t30
1/3 N3 depth 1: feed to 240 40 0 F120 t20
1/4 N4 depth 1: feed arc to 180 80 0 center 249.6135 119.4203 0 normal 0 0 1 sweep -53.5764 F120 t37.4034
10 N10: rapid to 100 0 0 t0.32
11: event end code="M30"
end of program: 31 blocks, 18 motions, 0 errors, 0 warnings
