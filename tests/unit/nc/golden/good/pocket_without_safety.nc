=== about
Without a safety distance the tool is taken to stand on the surface, with a warning. A corner radius below the tool's is the tool's.
proves: nct-23.6-P9999
=== settings
D1 = 5
=== main
G17 G90 G0 X0 Y0 Z0
G65 P9999 X20 Y10 Z4 R2 D1 Q4 F100
M30
=== truth
feed 0 0 -4 F 50
feed -5 0 -4 F 50
feed 5 0 -4 F 50
rapid 5 0 0
rapid 0 0 0
=== says
warning[nct-pocket-safety]
=== expect
file 0 main.nc
main.nc:2:1: warning[nct-pocket-safety]: no safety distance K: the tool is taken to stand on the surface
    G65 P9999 X20 Y10 Z4 R2 D1 Q4 F100
    ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
file 1 O9999 (built in)
1/6 depth 1: feed from 0 0 0 to 0 0 -4 F50 t4.8
1/8 depth 1: feed to -5 0 -4 F50 t6
1/9 depth 1: feed to 5 0 -4 F50 t12
1/34 depth 1: rapid to 5 0 0 t0.016
1/35 depth 1: rapid to 0 0 0 t0.02
3: event end code="M30"
end of program: 21 blocks, 5 motions, 0 errors, 1 warnings
