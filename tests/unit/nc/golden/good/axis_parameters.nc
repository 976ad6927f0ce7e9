=== about
Axes that the parameters name: number 4 is C, a table by N0106.ROT; number 5 is W2, parallel to Z by N0103; encoder unit and
decimals of the display change nothing.
proves: nct-2.2-N0100 nct-2.1-number nct-2.1-N0103 nct-5.6-N0106-1 nct-2.4-N0104 nct-2.4-N0105 nct-2.2-extname
=== settings
N0100.4 = 67
N0106.ROT.4 = 1
N0100.5 = 87
N0101.5 = 50
N0103.5 = 3
N0104.IND = 1
N0105 = 5
=== main
G0 X10 C90
W2=-3.25
AX[5]=-4
M30
=== truth
rapid 0 10 0 rotary 90
rapid 0 10 -3.25
rapid 0 10 -4
=== expect
file 0 main.nc
1: rapid arc from 0 0 0 to 0 10 0 center 0 0 0 normal 0 0 1 sweep 90 C 0 to 90 t0.36
2: rapid to 0 10 -3.25 C 90 to 90 t0.013
3: rapid to 0 10 -4 C 90 to 90 t0.003
4: event end code="M30"
end of program: 4 blocks, 3 motions, 0 errors, 0 warnings
