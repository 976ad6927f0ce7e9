=== about
Holes, R and bottom are scaled and mirrored, the shift I is not.
proves: nct-18-IJK nct-18-Q nct-18-hole nct-18-bottom nct-18-R
=== main
G90 G17 G0 X0 Y0 Z50 M3 S500
G51.1 X0 Z0
G51 X0 Y0 Z0 P2
G99 G76 X10 Y5 I-1 Z-25 R-10 F40
G80
G50
G50.1
M30
=== truth
0 0 50
-20 10 50 rapid
-20 10 20 rapid
-20 10 50 feed
-21 10 50 rapid
-21 10 20 rapid
-20 10 20 rapid
=== expect
file 0 main.nc
1: event spindle rpm=500 direction="cw"
1: rapid from 0 0 0 to 0 0 50 t0.2
4: rapid to -20 10 50 t0.08
4: rapid to -20 10 20 t0.12
4: feed to -20 10 50 F40 t45
4: event spindle rpm=0 direction="oriented"
4: rapid to -21 10 50 t0.004
4: rapid to -21 10 20 t0.12
4: rapid to -20 10 20 t0.004
4: event spindle rpm=500 direction="cw"
8: event end code="M30"
end of program: 8 blocks, 7 motions, 0 errors, 0 warnings
