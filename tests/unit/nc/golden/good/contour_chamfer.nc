=== about
proves: nct-1.1-commaC nct-17.1-C
=== main
N1 G17 G1 G91 X30 ,C10 F100
N2 X10 Y40
M30
=== truth
20 0 0
32.4254 9.7014 0
40 40 0
=== expect
file 0 main.nc
1 N1: feed from 0 0 0 to 20 0 0 F100 t12
1 N1: feed to 32.4254 9.7014 0 F100 t9.4585
2 N2: feed to 40 40 0 F100 t18.7386
3: event end code="M30"
end of program: 3 blocks, 3 motions, 0 errors, 0 warnings
