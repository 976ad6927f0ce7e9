=== about
Zone 2 of the parameters, outside forbidden, for Z alone.
proves: nct-22.2-param
=== settings
N1000.RE2.3 = 1
N1001.STE = 1
N1001.EXT = 1
N1006.3 = 50
N1007.3 = -20
max_errors = 9
=== main
G0 X1000 Z50
G1 X900 Z-30 F1000
M30
=== truth
1000 0 50
912.5 0 -20
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1000 0 50 t4
2: event forbidden_zone zone=2 alarm=3041 message="forbidden zone 2 Z -"
2: feed to 912.5 0 -20 F1000 t6.7233
main.nc:2:1: error[nct-3041]: forbidden zone 2 Z -
    G1 X900 Z-30 F1000
    ^~~~~~~~~~~~~~~~~~
3: event end code="M30"
end of program: 3 blocks, 2 motions, 1 errors, 0 warnings
