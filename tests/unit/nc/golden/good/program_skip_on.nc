=== about
proves: nct-14.2-skip
=== settings
skip = 1
=== main
/ N1200 G0 X200
/1 N1201 G0 Y200
/2 N1202 G0 Z200
M30
=== truth
0 0 200
=== expect
file 0 main.nc
3 N1202: rapid from 0 0 0 to 0 0 200 t0.8
4: event end code="M30"
end of program: 2 blocks, 1 motions, 0 errors, 0 warnings
