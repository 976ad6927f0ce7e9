=== about
There are no pallets: the place can be chosen, their data are vacant (words with them are left out).
proves: nct-23.1.21-#8500 nct-23.1.21-#8501 nct-23.1.21-#8502 nct-23.1.21-#8503 nct-23.1.21-#8504
nct-23.1.21-#8505 nct-23.1.21-#8531
=== main
G0 X#8500 Y1 Z1
#8500=11
X#8500 Y#8501 Z#8502
X12 Y#8503 Z#8504
X13 Y#8505 Z#8531
X14 Y#8534
M30
=== truth
10 1 1
11 1 1
12 1 1
13 1 1
14 1 1
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 10 1 1 t0.04
main.nc:2:1: note[nct-noted]: there are no pallets in the simulation: their data are vacant
    #8500=11
    ^~~~~~~~
3: rapid to 11 1 1 t0.004
4: rapid to 12 1 1 t0.004
5: rapid to 13 1 1 t0.004
6: rapid to 14 1 1 t0.004
7: event end code="M30"
end of program: 7 blocks, 5 motions, 0 errors, 0 warnings
