=== about
proves: nct-3-G54.1 nct-10.2.2-G54.1 nct-10.2.5-G10L20
=== main
G10 L20 P7 X100 Y20
G54.1 P7 G0 X1 Y2
G91 G10 L20 P7 X2
G90 X0
G54 X0
M30
=== truth
101 22 0
102 22 0
0 22 0
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 101 22 0 t0.404
4: rapid to 102 22 0 t0.004
5: rapid to 0 22 0 t0.408
6: event end code="M30"
end of program: 6 blocks, 3 motions, 0 errors, 0 warnings
