=== about
N1001.CBM: the motion does not start. 2058 2059, 2060, 2061, 2062, 2063 (printed as 2062 too) and 2056 2057.
Truth: the table of 22.4; only the last block moves.
proves: nct-22.4-CBM
=== settings
N1001.CBM = 1
N1000.RE3.1 = 1
N1008.1 = 50
N1009.1 = 20
N1002.3 = 100
N1003.3 = -100
max_errors = 20
=== main
G0 X30
G22 X60 Y100 Z50 I-100 J-100 K-50 P1
G0 X61
G22 X60 Y100 Z50 I-100 J-100 K-50 P1
G0 X-101
G22 X10 Y10 Z10 I5 J-10 K-10
G0 X7
G22 X10 Y10 Z10 I5 J-10 K-10
G0 X12
G23
G0 Z101
G23
G0 Z-100.1
G0 X5
M30
=== truth
rapid 5 0 0
=== says
main.nc:1:1: error[nct-2061]
main.nc:3:1: error[nct-2058]
main.nc:5:1: error[nct-2059]
main.nc:7:1: error[nct-2060]
main.nc:9:1: error[nct-2062]
main.nc:11:1: error[nct-2056]
main.nc:13:1: error[nct-2057]
1 motions, 7 errors
=== expect
file 0 main.nc
1: event forbidden_zone zone=3 alarm=2061 message="end point in inner forbidden zone 3"
main.nc:1:1: error[nct-2061]: end point in inner forbidden zone 3
    G0 X30
    ^~~~~~
3: event forbidden_zone zone=2 alarm=2058 message="end point in forbidden zone 2 X +"
main.nc:3:1: error[nct-2058]: end point in forbidden zone 2 X +
    G0 X61
    ^~~~~~
5: event forbidden_zone zone=2 alarm=2059 message="end point in forbidden zone 2 X -"
main.nc:5:1: error[nct-2059]: end point in forbidden zone 2 X -
    G0 X-101
    ^~~~~~~~
7: event forbidden_zone zone=2 alarm=2060 message="end point in inner forbidden zone 2"
main.nc:7:1: error[nct-2060]: end point in inner forbidden zone 2
    G0 X7
    ^~~~~
9: event forbidden_zone zone=2 alarm=2062 message="entry into inner forbidden zone 2"
main.nc:9:1: error[nct-2062]: entry into inner forbidden zone 2
    G0 X12
    ^~~~~~
11: event overtravel axis="Z" value=101 limit=100 alarm=2056
main.nc:11:1: error[nct-2056]: end point in positive end position on axis Z
    G0 Z101
    ^~~~~~~
13: event overtravel axis="Z" value=-100.1 limit=-100 alarm=2057
main.nc:13:1: error[nct-2057]: end point in negative end position on axis Z
    G0 Z-100.1
    ^~~~~~~~~~
14: rapid from 0 0 0 to 5 0 0 t0.02
15: event end code="M30"
end of program: 15 blocks, 1 motions, 7 errors, 0 warnings
