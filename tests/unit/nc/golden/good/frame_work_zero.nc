=== about
Programmed coordinates count from the work zero, increments do not depend on it.
proves: nct-1.3-WCS
=== settings
G55 = 100 50 -20
=== main
G90 G0 G55 X20 Y30 Z0
G91 X-40 Y-20 Z-5
G90 X0 Y0 Z0
M30
=== truth
120 80 -20
80 60 -25
100 50 -20
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 120 80 -20 t0.48
2: rapid to 80 60 -25 t0.16
3: rapid to 100 50 -20 t0.08
4: event end code="M30"
end of program: 4 blocks, 3 motions, 0 errors, 0 warnings
