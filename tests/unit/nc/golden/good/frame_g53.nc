=== about
Always absolute, and G91 stays.
proves: nct-3-G53 nct-10.1.1-G53 nct-10.1.1-G53-sync
=== settings
G54 = 0 0 -300
reference1 = 0 0 0
=== main
G91 G53 Z0
G53 X200 Y150 Z20
G53
G0 X1
M30
=== truth
0 0 300
200 150 320
201 150 320
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 300 t1.2
2: rapid to 200 150 320 t0.8
4: rapid to 201 150 320 t0.004
5: event end code="M30"
end of program: 5 blocks, 3 motions, 0 errors, 0 warnings
