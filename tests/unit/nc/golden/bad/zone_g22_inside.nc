=== about
G22 P0: from X150 to X-150 the way ends at X100, where the box begins; an arc enters it where the circle of 158.1139 about X0 Y200 passes X-100.
proves: nct-22.2-G22
=== settings
max_errors = 9
start = 150 0 0
=== main
G22 X100 Y100 Z50 I-100 J-100 K-50 P0
G0 X-150
G0 X150
Y150
G22 X100 Y100 Z50 I-100 J-100 K-50
G0 X-150 Y100
G0 X-150 Y150
G22 X100 Y100 Z50 I-100 J-100 K-50
G3 X150 Y150 I150 J50 F500
M30
=== truth
100 0 0
150 0 0
150 150 0
-150 100 0
-150 150 0
-100 77.5255 0 center 0 200 0
=== expect
file 0 main.nc
2: event forbidden_zone zone=2 alarm=3042 message="inner forbidden zone 2"
2: rapid from 150 0 0 to 100 0 0 t0.2
main.nc:2:1: error[nct-3042]: inner forbidden zone 2
    G0 X-150
    ^~~~~~~~
3: rapid to 150 0 0 t0.2
4: rapid to 150 150 0 t0.6
6: rapid to -150 100 0 t1.2
7: rapid to -150 150 0 t0.2
9: event forbidden_zone zone=2 alarm=3042 message="inner forbidden zone 2"
9: feed arc to -100 77.5255 0 center 0 200 0 normal 0 0 1 sweep 32.3335 F500 t10.7073
main.nc:9:1: error[nct-3042]: inner forbidden zone 2
    G3 X150 Y150 I150 J50 F500
    ^~~~~~~~~~~~~~~~~~~~~~~~~~
10: event end code="M30"
end of program: 10 blocks, 6 motions, 2 errors, 0 warnings
