=== about
The signal comes at the end of N10, and again at N30, when M97 has switched it off. The macro has locals of its own and leaves the
modal codes as they were.
proves: nct-13.1-M96 nct-13.1-M97 nct-23.4-M96 nct-23.4-M97 nct-23.4-M99
=== settings
N1758.USD = 1
N1758.TPI = 1
interrupt = 10
interrupt = 30
=== main
#1=1
M96 P50
N10 G1 G90 X10 F100
N20 X20
M97
N30 X#1 Y#500
M30
=== sub O0050
G91 G0 Z5
#500=#500+1
#1=77
M99
=== truth
feed 10 0 0
rapid 10 0 5
feed 20 0 5
feed 1 1 5
=== expect
file 0 main.nc
file 1 O0050
2: event function code="M96"
3 N10: feed from 0 0 0 to 10 0 0 F100 t6
1/1 depth 1: rapid to 10 0 5 t0.02
4 N20: feed to 20 0 5 F100 t6
5: event function code="M97"
6 N30: feed to 1 1 5 F100 t11.4158
main.nc:6:1: warning[nct-interrupt]: the interrupt signal comes here, but M96 has enabled no interrupt macro
    N30 X#1 Y#500
    ^~~~~~~~~~~~~
7: event end code="M30"
end of program: 11 blocks, 4 motions, 0 errors, 1 warnings
