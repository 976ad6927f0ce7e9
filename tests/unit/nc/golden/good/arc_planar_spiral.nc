=== about
The first spiral is 944.5726 mm long: 56.674 s at F1000.
proves: nct-4.3.1-spiral
=== main
G17 G90 G94 M3 S1000
G0 X90 Y0 F1000
G3 X-30 I-90 L3
G0 X50 Y0
G3 X-20 I-50 L1
M30
=== truth
90 0 0
-30 0 0 center 0 0 0 sweep 900 t 56.6744 at 0.1 0 84 0 at 0.2 -78 0 0 at 0.3 0 -72 0 at 0.4 66 0 0 at 0.8 42 0 0
50 0 0
-20 0 0 center 0 0 0 sweep 180 t 6.8534
=== expect
file 0 main.nc
1: event spindle rpm=1000 direction="cw"
2: rapid from 0 0 0 to 90 0 0 t0.36
3: feed arc to -30 0 0 center 0 0 0 normal 0 0 1 sweep 900 F1000 t56.6744
4: rapid to 50 0 0 t0.32
5: feed arc to -20 0 0 center 0 0 0 normal 0 0 1 sweep 180 F1000 t6.8534
6: event end code="M30"
end of program: 6 blocks, 4 motions, 0 errors, 0 warnings
