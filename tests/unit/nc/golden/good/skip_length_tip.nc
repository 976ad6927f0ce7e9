=== about
As skip_length with N1755.TLC: positions are read without the length offset.
proves: nct-21.1-G31
=== settings
H1 = 100
G54 = 10 20 30
N1755.TLC = 1
probe = plane 0 0 -1 -95
=== main
G43 G0 Z50 H1
G31 Z-40 F100
#103=#151103-#5063
G0 X#5063 Y#5003
X#103
M30
=== truth
0 0 150
probe 0 0 95
-5 -5 95
30 -5 95
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 150 t0.6
2: probe to 0 0 95 F100 t33
2: event probe contact=true
4: rapid to -5 -5 95 t0.02
5: rapid to 30 -5 95 t0.14
6: event end code="M30"
end of program: 6 blocks, 4 motions, 0 errors, 0 warnings
