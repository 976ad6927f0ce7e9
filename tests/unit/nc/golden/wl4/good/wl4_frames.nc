=== about
Offsets act with the first motion of each axis; G92; G53; G91 and U V W; mirroring.
proves: wl4-5.10-G55 wl4-5.10-G56 wl4-5.10-G57 wl4-5.10-G58 wl4-5.10-G59 wl4-5.10-G53 wl4-5.9-G92 wl4-5.8-G91 wl4-4.2-UVW wl4-5.11-G51 wl4-5.11-G50 wl4-9.2-103
=== settings
control = wl4-mill
G55 = 10 20 30
G56 = 5 5 5
G57 = 7 0 0
G58 = 8 0 0
G59 = 9 0 0
=== main
%FRAMES
G54 G0 X1 Y1 Z1
G55 X1
Y1
G56 Z1
G91 X1 Y1
G90 G53 X0 Y0 Z0
G92 X100 Y200
X101
G54 X10 Y10 Z10
G51 X-1
X5
U5
X20 Y20
G51 X1 Y-1
X20 Y5
G50
X0 Y0
V3
G57 X1
G58 X1
G59 X1
Y#103
M30
%
=== truth
rapid 1 1 1
rapid 11 1 1
rapid 11 21 1
rapid 11 21 6
rapid 7 7 6
rapid 0 0 0
rapid 1 0 0
rapid 10 10 10
rapid -5 10 10
rapid -10 10 10
rapid -20 20 10
rapid 20 -5 10
rapid 0 0 10
rapid 0 3 10
rapid 8 3 10
rapid 9 3 10
rapid 10 3 10
rapid 10 59 10
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 1 1 1 t0.004
main.nc:3:1: warning[wl4-offset]: G55 has no value in the job: 0 is taken (--offset G55=X,Y,Z)
    G55 X1
    ^~~~~~
3: rapid to 11 1 1 t0.04
4: rapid to 11 21 1 t0.08
main.nc:5:1: warning[wl4-offset]: G56 has no value in the job: 0 is taken (--offset G56=X,Y,Z)
    G56 Z1
    ^~~~~~
5: rapid to 11 21 6 t0.02
6: rapid to 7 7 6 t0.056
7: rapid to 0 0 0 t0.028
9: rapid to 1 0 0 t0.004
10: rapid to 10 10 10 t0.04
12: rapid to -5 10 10 t0.06
13: rapid to -10 10 10 t0.02
14: rapid to -20 20 10 t0.04
16: rapid to 20 -5 10 t0.16
18: rapid to 0 0 10 t0.08
19: rapid to 0 3 10 t0.012
main.nc:20:1: warning[wl4-offset]: G57 has no value in the job: 0 is taken (--offset G57=X,Y,Z)
    G57 X1
    ^~~~~~
20: rapid to 8 3 10 t0.032
main.nc:21:1: warning[wl4-offset]: G58 has no value in the job: 0 is taken (--offset G58=X,Y,Z)
    G58 X1
    ^~~~~~
21: rapid to 9 3 10 t0.004
main.nc:22:1: warning[wl4-offset]: G59 has no value in the job: 0 is taken (--offset G59=X,Y,Z)
    G59 X1
    ^~~~~~
22: rapid to 10 3 10 t0.004
23: rapid to 10 59 10 t0.224
24: event end code="M30"
end of program: 23 blocks, 18 motions, 0 errors, 5 warnings
