=== about
Inside the macro #4401 to #4530 tell the modal codes and words of the interrupted block.
proves: nct-23.4-modals
=== settings
N1758.USD = 1
N1758.TPI = 1
interrupt = 10
=== main
M96 P50
N10 G1 G90 X10 F100
G0 X#501 Y#502
X#503 Y#504
X#505
IF[#4401EQ#0] X7 (vacant outside of the macro)
M30
=== sub O0050
G91 G0 Z5 F777
#501=#4401
#502=#4403
#503=#4001
#504=#4003
#505=#4509
M99
=== truth
feed 10 0 0
rapid 10 0 5
rapid 1 90 5
rapid 0 91 5
rapid 100 91 5
rapid 7 91 5
=== expect
file 0 main.nc
file 1 O0050
1: event function code="M96"
2 N10: feed from 0 0 0 to 10 0 0 F100 t6
1/1 depth 1: rapid to 10 0 5 t0.02
3: rapid to 1 90 5 t0.36
4: rapid to 0 91 5 t0.004
5: rapid to 100 91 5 t0.4
6: rapid to 7 91 5 t0.372
7: event end code="M30"
end of program: 14 blocks, 6 motions, 0 errors, 0 warnings
