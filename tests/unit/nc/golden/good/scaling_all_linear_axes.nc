=== about
P holds for all linear axes; the centre of those without a word is where they stand: W goes from 10 to 30.
proves: nct-16.2-G51-P
=== settings
axis = W 4 linear parallel Z
=== main
G90 G0 X10 Y10 Z10 W10
G51 Z0 P2
X20 Y20 Z20 W20
G50
M30
=== truth
10 10 20
30 30 70
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 10 10 20 t0.04
3: rapid to 30 30 70 t0.12
5: event end code="M30"
end of program: 5 blocks, 2 motions, 0 errors, 0 warnings
