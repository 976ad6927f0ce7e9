=== about
Every repetition starts with the same arguments; a macro by its file name.
proves: nct-23.3.1-G65 nct-23.3-lookup
=== main
G91 G0
G65 P11 L3 X5
G65 <sub one.nc> A2
X100
M30
=== sub O0011
X#24
#24=1000
M99
=== sub sub one.nc
Y#1
M99
=== truth
rapid 5 0 0
rapid 10 0 0
rapid 15 0 0
rapid 15 2 0
rapid 115 2 0
=== expect
file 0 main.nc
file 1 O0011
1/1 depth 1: rapid from 0 0 0 to 5 0 0 t0.02
1/1 depth 1: rapid to 10 0 0 t0.02
1/1 depth 1: rapid to 15 0 0 t0.02
file 2 sub one.nc
2/1 depth 1: rapid to 15 2 0 t0.008
4: rapid to 115 2 0 t0.4
5: event end code="M30"
end of program: 16 blocks, 5 motions, 0 errors, 0 warnings
