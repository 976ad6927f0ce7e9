=== about
Without N1758.USD the codes belong to the machine builder.
proves: nct-23.4-N1758
=== settings
interrupt = 10
=== main
M96 P50
N10 G0 X10
M97
M30
=== truth
rapid 10 0 0
=== expect
file 0 main.nc
main.nc:1:1: warning[nct-interrupt]: M96 and M97 are functions of the machine builder: interrupt macros are off (N1758.USD = 0)
    M96 P50
    ^~~
1: event function code="M96"
2 N10: rapid from 0 0 0 to 10 0 0 t0.04
main.nc:2:1: warning[nct-interrupt]: the interrupt signal comes here, but M96 has enabled no interrupt macro
    N10 G0 X10
    ^~~~~~~~~~
3: event function code="M97"
4: event end code="M30"
end of program: 4 blocks, 1 motions, 0 errors, 2 warnings
