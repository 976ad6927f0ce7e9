=== about
N1759 and N1760 name the codes, the macro shares the locals and lies among the system macros.
proves: nct-23.4-N1758
=== settings
N1758.USD = 1
N1758.STP = 1
N1758.TPI = 1
N1758.MCD = 1
N1758.SYM = 1
N1759 = 150
N1760 = 151
interrupt = 10
interrupt = 20
=== main
#1=1
M98 P11
N10 G0 X10
X#1
M151
N20 X20
M30
=== sub O0011
M150 P50
M99
=== sub SystemMacros/Channel1/O0050.nct
G91 G0 Z5
#500=#500+1
#1=77
M99
=== truth
rapid 10 0 0
rapid 10 0 5
rapid 77 0 5
rapid 20 0 5
=== expect
file 0 main.nc
file 1 O0011
file 2 SystemMacros/Channel1/O0050.nct
1/1 depth 1: event function code="M150"
3 N10: rapid from 0 0 0 to 10 0 0 t0.04
2/1 depth 1: rapid to 10 0 5 t0.02
4: rapid to 77 0 5 t0.268
5: event function code="M151"
6 N20: rapid to 20 0 5 t0.228
main.nc:6:1: warning[nct-interrupt]: the interrupt signal comes here, but M96 has enabled no interrupt macro
    N20 X20
    ^~~~~~~
7: event end code="M30"
end of program: 13 blocks, 4 motions, 0 errors, 1 warnings
