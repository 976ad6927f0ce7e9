=== about
Software limits of the stroke, range A: 3010 and 3011, the axis stops at the limit. An arc goes beyond Y although its ends do not.
proves: nct-22.1-stroke
=== settings
N1002.1 = 100
N1003.1 = -100
N1002.2 = 80
N1003.2 = -80
max_errors = 9
=== main
G0 X50
X110 Y6
G0 X0 Y0
M30
M30
=== truth
50 0 0
100 5 0
0 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 50 0 0 t0.2
2: event overtravel axis="X" value=110 limit=100 alarm=3010
2: rapid to 100 5 0 t0.2
main.nc:2:1: error[nct-3010]: ran onto positive end position on axis X
    X110 Y6
    ^~~~~~~
3: rapid to 0 0 0 t0.4
4: event end code="M30"
end of program: 4 blocks, 3 motions, 1 errors, 0 warnings
