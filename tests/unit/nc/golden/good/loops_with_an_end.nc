=== about
What looks like a loop without an end and has one: repeated calls of the same program, one that waits for a clock,
counters that go up by little.
Truth: 20 calls of two moves; five dwells of 1 s until the clock shows 5000 ms; #1 ends at 100.
=== main
G0 X1 Y1
M98 P3 L20
#3001=0
WHILE[#3001 LT 5000] DO1
G4 P1
END1
#1=0
WHILE[#1 LT 100] DO1
#1=#1+1
END1
G0 X#1
M30
=== sub O0003.nc
G0 X2
X1
M99
=== truth
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 2 1 0
rapid 1 1 0
rapid 100 1 0
=== says
5: event dwell seconds=1
5: event dwell seconds=1
5: event dwell seconds=1
5: event dwell seconds=1
5: event dwell seconds=1
42 motions, 0 errors
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 1 0 t0.004
file 1 O0003.nc
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
1/1 depth 1: rapid to 2 1 0 t0.004
1/2 depth 1: rapid to 1 1 0 t0.004
5: event dwell seconds=1
5: event dwell seconds=1
5: event dwell seconds=1
5: event dwell seconds=1
5: event dwell seconds=1
11: rapid to 100 1 0 t0.396
12: event end code="M30"
end of program: 383 blocks, 42 motions, 0 errors, 0 warnings
