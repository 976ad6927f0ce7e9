=== about
G22 P1: 3040 and 3041 with the axis, at the border. The area is not watched any more once it has given its alarm.
proves: nct-22.2-G22
=== settings
max_errors = 9
=== main
G22 X100 Y100 Z50 I-100 J-100 K-50 P1
G0 X101 Y10.1
G22 X100 Y100 Z50 I-100 J-100 K-50 P1
G1 X-101 F1000
G0 X0 Y0
G22 X100 Y100 Z50 I-100 J-100 K-50 P1
G3 X0 Y0 I60 F1000
G0 X0 Y0
G22 X1 Y2 Z3 I1 J2 K3 P1
G0 X1 Y2 Z3
M30
=== truth
100 10 0
-100 10 0
0 0 0
feed 100 -44.7214 0 center 60 0 0
0 0 0
=== expect
file 0 main.nc
2: event forbidden_zone zone=2 alarm=3040 message="forbidden zone 2 X +"
2: rapid from 0 0 0 to 100 10 0 t0.4
main.nc:2:1: error[nct-3040]: forbidden zone 2 X +
    G0 X101 Y10.1
    ^~~~~~~~~~~~~
4: event forbidden_zone zone=2 alarm=3041 message="forbidden zone 2 X -"
4: feed to -100 10 0 F1000 t12
main.nc:4:1: error[nct-3041]: forbidden zone 2 X -
    G1 X-101 F1000
    ^~~~~~~~~~~~~~
5: rapid to 0 0 0 t0.4
7: event forbidden_zone zone=2 alarm=3040 message="forbidden zone 2 X +"
7: feed arc to 100 -44.7214 0 center 60 0 0 normal 0 0 1 sweep 131.8103 F1000 t8.2819
main.nc:7:1: error[nct-3040]: forbidden zone 2 X +
    G3 X0 Y0 I60 F1000
    ^~~~~~~~~~~~~~~~~~
8: rapid to 0 0 0 t0.4
10: event forbidden_zone zone=2 alarm=3040 message="forbidden zone 2 X +"
main.nc:10:1: error[nct-3040]: forbidden zone 2 X +
    G0 X1 Y2 Z3
    ^~~~~~~~~~~
11: event end code="M30"
end of program: 11 blocks, 5 motions, 4 errors, 0 warnings
