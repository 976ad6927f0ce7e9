=== about
Zone 2 of the parameters, inside forbidden, X and Y take part: Z counts for nothing. G22 stands for it until G23.
proves: nct-22.2-param
=== settings
N1000.RE2.1 = 1
N1000.RE2.2 = 1
N1001.STE = 1
N1006.1 = 50
N1007.1 = 20
N1006.2 = 40
N1007.2 = -40
max_errors = 9
=== main
G22 X1 Y1 Z1 I1 J1 K1 P0
G0 X30 Z-500
X0
G23
N70 G1 X100 Y20 F1000
M3 S1
M30
=== truth
30 0 -500
0 0 -500
20 4 -500
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 30 0 -500 t2
3: rapid to 0 0 -500 t0.12
5 N70: event forbidden_zone zone=2 alarm=3042 message="inner forbidden zone 2"
5 N70: feed to 20 4 -500 F1000 t1.2238
main.nc:5:1: error[nct-3042]: inner forbidden zone 2
    N70 G1 X100 Y20 F1000
    ^~~~~~~~~~~~~~~~~~~~~
6: event spindle rpm=1 direction="cw"
7: event end code="M30"
end of program: 7 blocks, 3 motions, 1 errors, 0 warnings
