=== about
proves: nct-14.2-skip
=== main
/ N1200 G0 X200
/1 N1201 G0 Y200
M30
=== truth
200 0 0
200 200 0
=== expect
file 0 main.nc
1 N1200: rapid from 0 0 0 to 200 0 0 t0.8
2 N1201: rapid to 200 200 0 t0.8
3: event end code="M30"
end of program: 3 blocks, 2 motions, 0 errors, 0 warnings
