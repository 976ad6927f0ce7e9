=== about
M99 P goes on at another block, with the modal codes of the macro.
proves: nct-23.4-M99
=== settings
N1758.USD = 1
interrupt = 10
=== main
M96 P50
N10 G1 G90 X10 F100
N20 X999
N40 X1
M30
=== sub O0050
G91 G0 Z5
M99 P40
=== truth
feed 10 0 0
rapid 10 0 5
rapid 11 0 5
=== expect
file 0 main.nc
file 1 O0050
1: event function code="M96"
2 N10: feed from 0 0 0 to 10 0 0 F100 t6
main.nc:2:1: warning[nct-interrupt]: the interrupt macro would start inside the block (N1758.TPI = 0): it starts at the block's end
    N10 G1 G90 X10 F100
    ^~~~~~~~~~~~~~~~~~~
1/1 depth 1: rapid to 10 0 5 t0.02
4 N40: rapid to 11 0 5 t0.004
5: event end code="M30"
end of program: 6 blocks, 3 motions, 0 errors, 1 warnings
