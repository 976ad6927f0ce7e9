=== about
Without STE zone 2 of the parameters is not watched.
proves: nct-22.2-param
=== settings
N1000.RE2.3 = 1
N1001.EXT = 1
N1006.3 = 50
N1007.3 = -20
=== main
G0 Z100
M30
=== truth
0 0 100
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 100 t0.4
2: event end code="M30"
end of program: 2 blocks, 1 motions, 0 errors, 0 warnings
