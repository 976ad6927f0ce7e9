=== about
A function in a block of a cycle acts behind the positioning, with L at the first hole alone.
proves: nct-18.2-M nct-18-L
=== main
G0 Z10
G91 G81 X10 Z-2 R-8 F100 L2 M8
G80
M30
=== truth
0 0 10
10 0 10
10 0 2
10 0 0
10 0 10
20 0 10
20 0 2
20 0 0
20 0 10
=== says
rapid to 10 0 10
coolant code="M8"
rapid to 10 0 2
rapid to 20 0 10
rapid to 20 0 2
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 10 t0.04
2: rapid to 10 0 10 t0.04
2: event coolant code="M8" on=true
2: rapid to 10 0 2 t0.032
2: feed to 10 0 0 F100 t1.2
2: rapid to 10 0 10 t0.04
2: rapid to 20 0 10 t0.04
2: rapid to 20 0 2 t0.032
2: feed to 20 0 0 F100 t1.2
2: rapid to 20 0 10 t0.04
4: event end code="M30"
end of program: 4 blocks, 9 motions, 0 errors, 0 warnings
